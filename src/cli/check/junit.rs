//! A verdict as a JUnit report, which continuous integration shows.

use carom::judge::Standing;
use carom::log::Judgement;
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use super::message;

/// A report of one test case, which fails if nothing excuses a difference.
pub(super) fn report(judgement: &Judgement) -> String {
    let mut case = TestCase::new(judgement.scene.as_str(), status(judgement));
    case.set_system_out(message::text(judgement));
    let mut suite = TestSuite::new("carom check");
    suite.add_test_case(case);
    let mut report = Report::new("carom");
    report.add_test_suite(suite);
    report
        .to_string()
        .expect("a text takes all that is written to it")
}

fn status(judgement: &Judgement) -> TestCaseStatus {
    if judgement.verdict != Standing::Differs {
        return TestCaseStatus::success();
    }
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
    status.set_message(message::headline(judgement.verdict));
    if let Some(difference) = &judgement.difference {
        status.set_description(message::told(difference).join("\n"));
    }
    status
}
