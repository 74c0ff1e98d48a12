// The report page of a real batch in a real browser. Started by report_in_a_browser.sh, which says what it needs.
import "./verdict_tests.mjs";
import "./plot_tests.mjs";
import "./robot_tests.mjs";
import "./replay_tests.mjs";
import "./page_tests.mjs";
import "./campaign_tests.mjs";
import "./self_tests.mjs";
