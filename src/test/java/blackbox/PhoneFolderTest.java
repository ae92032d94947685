package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** What a phone keeps in its {@code --data} folder is there after any end of the program, and one phone keeps it. */
class PhoneFolderTest {
    @Test
    void whatThePhoneHasReportedIsKeptWhenItIsKilled() throws Exception {
        try (Scenario scenario = new Scenario("a phone that keeps its messages is killed")) {
            scenario.center();
            String folder = scenario.folder().resolve("phones").toString();
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--data", folder);
            for (int i = 1; i <= 3; i++) {
                phone.say("sms " + Scenario.PHONE + " note " + i);
                phone.expect("sms", "text", "note " + i);
            }
            phone.kill();
            phone = scenario.phone(Scenario.PHONE, "--data", folder);
            phone.say("inbox");
            for (int i = 1; i <= 3; i++) {
                phone.expectNext("message", "from", Scenario.PHONE, "text", "note " + i, "read", "false");
            }
            phone.expectNext("end", "of", "inbox", "count", "3");
            phone.kill();
            phone = scenario.phone(Scenario.PHONE, "--data", folder);
            phone.say("inbox");
            phone.expectNext("message", "text", "note 1", "read", "true");
        }
    }

    @Test
    void aSecondPhoneOfTheSameNumberAndFolderSaysWhyItEnds() throws Exception {
        try (Scenario scenario = new Scenario("two phones with one folder")) {
            scenario.center();
            String folder = scenario.folder().resolve("phones").toString();
            RunningProgram first = scenario.phone(Scenario.PHONE, "--data", folder);
            RunningProgram second = scenario.start(
                    "second", "simgsm-phone", "--headless", "--number", Scenario.PHONE, "--data", folder);
            assertEquals(74, second.awaitExit());
            assertEquals(
                    "simgsm-phone: another phone 5550100 holds the data directory " + folder
                            + "; expected another one by --data DIR",
                    second.log().strip());
            RunningProgram other = scenario.phone("5550101", "--data", folder);
            first.say("sms 5550101 hello");
            other.expect("sms", "text", "hello");
            assertEquals(0, first.quit());
            RunningProgram again = scenario.phone(Scenario.PHONE, "--data", folder);
            assertTrue(again.toString().contains("registered"));
        }
    }
}
