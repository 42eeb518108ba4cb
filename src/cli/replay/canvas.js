// A canvas as sharp as the screen, empty: its pen and its size.
function prepare(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
  if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return [pen, width, height];
}

// What is drawn in a view of the plane.
class Plane {
  constructor(canvas, view) {
    const [pen, width, height] = prepare(canvas);
    const across = view.right - view.left || 1;
    const up = view.high - view.low || 1;
    this.pen = pen;
    this.scale = Math.min((width - 20) / across, (height - 20) / up);
    this.place = ([x, y]) => [
      width / 2 + (x - (view.left + view.right) / 2) * this.scale,
      height / 2 - (y - (view.low + view.high) / 2) * this.scale,
    ];
  }

  line(from, to) {
    this.pen.beginPath();
    this.pen.moveTo(...this.place(from));
    this.pen.lineTo(...this.place(to));
    this.pen.stroke();
  }

  // A circle to be filled or stroked, as much wider as is said, in pixels.
  circle(centre, radius, wider = 0) {
    this.pen.beginPath();
    this.pen.arc(...this.place(centre), Math.max(radius * this.scale + wider, 0), 0, 2 * Math.PI);
    return this.pen;
  }

  cross(centre, radius) {
    const part = radius * Math.SQRT1_2;
    const [x, y] = centre;
    this.line([x - part, y - part], [x + part, y + part]);
    this.line([x - part, y + part], [x + part, y - part]);
  }
}

// How a fault looks on a disc: not by its colour alone.
const looks = {
  missed(plane, centre, radius) {
    plane.pen.setLineDash([4, 3]);
    plane.circle(centre, radius, 2).stroke();
    plane.pen.setLineDash([]);
  },
  spurious(plane, centre, radius) {
    plane.circle(centre, radius, 2).stroke();
    plane.cross(centre, radius);
  },
  misordered(plane, centre, radius) {
    plane.circle(centre, radius, 2).stroke();
    plane.circle(centre, radius, -3).stroke();
  },
};
