package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** An application at the SMPP port is a user of the network like any phone: it drives the robot and talks with phones. */
class SmppOrdersTest {
    private static final String SERVICE = "5550300";

    @Test
    void anApplicationDrivesTheRobotAndGetsTheOutcome() throws Exception {
        try (Scenario scenario = new Scenario("an application drives the robot by SMPP")) {
            RunningProgram center = scenario.center("--smpp", "0");
            RunningProgram robot = scenario.robot("empty.map", "--speed", "20");
            robot.ask("place 0 0 0", "pose");
            try (SmppApplication application = application(scenario, "", SERVICE)) {
                scenario.tell("the order goes out and is acknowledged with a message id");
                String id = application.submit(Scenario.ROBOT, "** #**20 **", true);
                robot.expect("order", "verdict", "accepted");
                scenario.tell("the receipt and the robot's own reply come back");
                SmppApplication.Delivery receipt = application.await(true);
                assertTrue(receipt.text().startsWith("id:" + id + " sub:001 dlvrd:001 "), receipt.text());
                assertTrue(receipt.text().contains(" stat:DELIVRD err:000 "), receipt.text());
                scenario.tell("the message is delivered before the robot has arrived: the next order waits for that");
                robot.expect("reply", "to", SERVICE);
            }
            scenario.tell("another session of the application gets what the first one may have missed");
            try (SmppApplication application = application(scenario, "", SERVICE)) {
                application.submit(Scenario.ROBOT, "** #*#90 **", false);
                SmppApplication.Delivery reply = application.await(false);
                assertEquals(Scenario.ROBOT, reply.from());
                assertEquals(SERVICE, reply.to());
                assertTrue(reply.text().startsWith("3 Done"), reply.text());
                application.unbind();
            }
            assertEquals(0, center.quit());
        }
    }

    @Test
    void aPhoneAndAnApplicationWriteToEachOther() throws Exception {
        try (Scenario scenario = new Scenario("a phone and an application")) {
            scenario.center("--smpp", "0");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.tell("what the phone sends waits until the application comes");
            phone.say("sms " + SERVICE + " what time is it?");
            phone.expect("sms-sent");
            try (SmppApplication application = application(scenario, "", SERVICE)) {
                SmppApplication.Delivery question = application.await(false);
                assertEquals(Scenario.PHONE, question.from());
                assertEquals("what time is it?", question.text());
                phone.expect("sms-delivered");
                application.submit(Scenario.PHONE, "time for tea", false);
                phone.expect("sms", "from", SERVICE, "text", "time for tea");
            }
        }
    }

    @Test
    void aPhonesNumberIsServedByTheApplicationThatListsItOnlyEvenWhenThePhoneIsAway() throws Exception {
        try (Scenario scenario = new Scenario("a phone's number and applications")) {
            Path data = Files.createDirectories(scenario.folder().resolve("data"));
            Files.writeString(
                    data.resolve("smpp-users.properties"), "robotics=\ndesk=\ndesk.numbers=" + Scenario.PHONE);
            scenario.center("--smpp", "0");
            scenario.phone(Scenario.PHONE).quit();
            int port = scenario.smppPort();
            assertThrows(IOException.class, () -> application(scenario, "", Scenario.PHONE));
            application(scenario, "", SERVICE).close();
            new SmppApplication(port, "desk", "", Scenario.PHONE).close();
            assertThrows(IOException.class, () -> new SmppApplication(port, "desk", "", SERVICE));
        }
    }

    @Test
    void onlyTheApplicationsOfTheUserFileBind() throws Exception {
        try (Scenario scenario = new Scenario("applications with passwords")) {
            Path data = Files.createDirectories(scenario.folder().resolve("data"));
            Files.writeString(data.resolve("smpp-users.properties"), "robotics=secret\n");
            scenario.center("--smpp", "0");
            assertThrows(IOException.class, () -> application(scenario, "guess", SERVICE));
            application(scenario, "secret", SERVICE).close();
        }
    }

    private static SmppApplication application(Scenario scenario, String password, String number) throws IOException {
        return new SmppApplication(scenario.smppPort(), "robotics", password, number);
    }
}
