package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Phone and robot reach the centre by towers: registration, messages, orders by tones, handover, a tower that dies. */
class TowersTest {
    private final Scenario scenario = new Scenario("towers between terminals and the centre");
    private RunningProgram center;
    private RunningProgram cells;
    private RunningProgram phone;
    private RunningProgram robot;

    @BeforeEach
    void start() {
        center = scenario.center();
        cells = scenario.start(
                "cells",
                "simgsm-cells",
                "--headless",
                "--lang",
                "en",
                "--town",
                Scenario.world("village.town").toString(),
                "--center",
                scenario.centerAddress(),
                "--port",
                "0");
        String towers = "127.0.0.1:" + cells.expect("ready").field("port");
        phone = scenario.phone(Scenario.PHONE, "--center", towers);
        robot = scenario.robot("empty.map", "--center", towers);
    }

    @AfterEach
    void close() throws Exception {
        scenario.close();
    }

    @Test
    void anOrderByMessageAndItsReplyPassTheTowers() {
        phone.say("sms " + Scenario.ROBOT + " ** #**20 **");

        phone.expect("sms-sent", "to", Scenario.ROBOT);
        robot.expect("order", "verdict", "accepted");
        phone.expect("sms", "from", Scenario.ROBOT);
    }

    @Test
    void aCallIsHandedOverInTheMiddleOfAnOrderAndTheNextOneIsHeardToo() {
        scenario.call(phone);
        phone.say("press **#**400**");
        phone.expect("tone", "key", "6");

        cells.say("place " + Scenario.PHONE + " 3700 0");

        cells.expect("handover", "number", Scenario.PHONE, "from", "west", "to", "east", "result", "success");
        int gapMillis = SpeechGap.of(cells);
        phone.expect("tone", "key", "3");
        robot.expect("pose", "x", "4.0000", "y", "0.0000");
        phone.say("press **#*#90**");
        phone.expect("tone", "key", "3");
        robot.expect("pose", "heading", "270.00");
        SpeechGap.requireShort(gapMillis, cells);
        phone.say("hangup");
        center.expect("call", "from", Scenario.PHONE, "state", "released");
    }

    @Test
    void aTowerThatIsSwitchedOffInMidCallEndsTheCallAndTheRobotStops() {
        scenario.call(phone);
        phone.say("press **#**900**");
        robot.expect("status", "value", "Moving");

        cells.say("tower west off");

        robot.expect("released");
        robot.expect("status", "value", "Stopped");
        phone.expect("released");
        center.expect("call", "from", Scenario.PHONE, "state", "released");
    }

    @Test
    void aMobileInTheOtherCellIsPagedThere() throws Exception {
        cells.say("place " + Scenario.ROBOT + " 3700 0");
        cells.expect("camped", "number", Scenario.ROBOT, "cell", "east");

        scenario.call(phone);

        assertEquals(0, phone.quit());
    }
}
