package blackbox;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** Software for real Pioneers drives the simulated one, alone and beside a telephone. */
class PioneerClientsTest {
    private static RunningProgram robot(Scenario scenario, String... options) {
        String[] all = new String[options.length + 9];
        String[] first = {
            "--headless",
            "--lang",
            "en",
            "--world",
            Scenario.world("empty.map").toString(),
            "--center",
            "127.0.0.1:1",
            "--p2os",
            "0"
        };
        System.arraycopy(first, 0, all, 0, first.length);
        System.arraycopy(options, 0, all, first.length, options.length);
        return scenario.start("robot", "simrobot", all);
    }

    @Test
    void aClientDrivesTurnsCollidesBacksAwayAndComesAgain() throws Exception {
        try (Scenario scenario = new Scenario("a P2OS client")) {
            RunningProgram robot = robot(scenario);
            String port = robot.expect("ready").field("p2os");
            ConsoleEvent before = robot.ask("pose", "pose");
            try (PioneerClient client = new PioneerClient(port)) {
                assertEquals("robot/Pioneer/p3dx/", client.name());
                assertEquals(16, client.information().sonars().length);
                client.command(PioneerClient.CONFIG, 1);
                String configuration = new String(client.packetWithId(0x20), StandardCharsets.US_ASCII);
                assertTrue(configuration.startsWith(" Pioneer\0p3dx\0SIM\0"), configuration);

                scenario.tell("500 mm ahead, then 90 degrees left");
                client.command(PioneerClient.MOVE, 500);
                assertEquals(500, client.untilItHasMoved().x(), 0.5);
                client.command(PioneerClient.DHEAD, 90);
                PioneerClient.Information turned = client.untilItHasMoved();
                assertEquals(90, turned.heading(), 0.1);
                ConsoleEvent after = robot.ask("pose", "pose");
                assertEquals(0.5, after.number("x") - before.number("x"), 0.001);
                assertEquals(90, after.number("heading"), 0.01);

                scenario.tell("its sonars are those of the console");
                String[] heard = robot.ask("sonar", "sonar").field("ranges").split(",");
                int[] console = java.util.Arrays.stream(heard)
                        .mapToInt(Integer::parseInt)
                        .toArray();
                assertArrayEquals(console, turned.sonars());

                scenario.tell("being carried away does not touch the odometry");
                robot.ask("place 9.6 0 0", "pose");
                assertEquals(500, client.information().x(), 0.5);

                scenario.tell("into the wall");
                client.command(PioneerClient.VEL, 200);
                PioneerClient.Information stuck = client.untilItHasMoved();
                assertTrue(stuck.stalled());
                assertEquals(0b00100, stuck.frontBumpers());
                robot.expect("status", "value", "Collision");
                assertEquals(9.75, robot.ask("pose", "pose").number("x"), 0.001);

                scenario.tell("and back");
                client.command(PioneerClient.MOVE, -300);
                assertFalse(client.untilItHasMoved().stalled());
                robot.expect("status", "value", "Stopped");
                assertEquals(9.45, robot.ask("pose", "pose").number("x"), 0.001);
                client.leave();
            }
            scenario.tell("the port serves the next client at once");
            try (PioneerClient again = new PioneerClient(port)) {
                assertEquals(16, again.information().sonars().length);
            }
            assertEquals(0, robot.quit());
        }
    }

    @Test
    void aTelephoneAndAClientShareTheRobotAndItsStatus() throws Exception {
        try (Scenario scenario = new Scenario("a telephone and a P2OS client")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--p2os=0");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            try (PioneerClient client = new PioneerClient(robot.said("ready").field("p2os"))) {
                Thread listening = new Thread(() -> listen(client));
                listening.setDaemon(true);
                scenario.call(phone);

                scenario.tell("while the client drives, an order finds the robot moving");
                client.command(PioneerClient.VEL, 100);
                listening.start();
                robot.expect("status", "value", "Moving");
                phone.say("press **#**20**");
                phone.expectNext("tone", "key", "6");
                robot.expect("outcome", "tone", "6");

                scenario.tell("a stop by telephone holds it");
                phone.say("press **###**");
                phone.expectNext("tone", "key", "3");
                robot.expect("status", "value", "Stopped");

                scenario.tell("then the order is executed, and the client cannot turn it aside");
                ConsoleEvent before = robot.ask("pose", "pose");
                phone.say("press **#**50**");
                phone.expectNext("tone", "key", "6");
                client.command(PioneerClient.VEL, -100);
                phone.expectNext("tone", "key", "3");
                ConsoleEvent after = robot.ask("pose", "pose");
                assertEquals(0.5, after.number("x") - before.number("x"), 0.001);

                scenario.tell("motors off by the client are motors off for the telephone");
                client.command(PioneerClient.ENABLE, 0);
                robot.expect("status", "value", "No motors");
                phone.say("press **#**20**");
                phone.expectNext("tone", "key", "8");
            }
        }
    }

    private static void listen(PioneerClient client) {
        try {
            while (true) {
                client.information();
            }
        } catch (java.io.IOException ended) {
            // the client has left
        }
    }

    @Test
    void eachRobotHasAPortOfItsOwn() throws Exception {
        try (Scenario scenario = new Scenario("two robots, two ports")) {
            RunningProgram robots = robot(scenario, "--robot", "ann=5550201", "--robot", "bob=5550202");
            String[] ports = robots.expect("ready").field("p2os").split(",");
            try (PioneerClient ann = new PioneerClient(ports[0]);
                    PioneerClient bob = new PioneerClient(ports[1])) {
                assertEquals("ann/Pioneer/p3dx/", ann.name());
                assertEquals("bob/Pioneer/p3dx/", bob.name());
                bob.command(PioneerClient.DHEAD, -90);
                assertEquals(-90, bob.untilItHasMoved().heading(), 0.1);
                assertEquals(0, ann.information().heading());
            }
            assertEquals(0, robots.quit());
        }
    }
}
