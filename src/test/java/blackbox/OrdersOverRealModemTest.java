package blackbox;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Tag;

/**
 * The scenarios of M2 with a modem in its place: SimRobot sits behind the AT port of a phone, which has the robot's number.
 * They repeat whole test classes, so they run with the peers.
 */
@Tag("peer")
class OrdersOverRealModemTest {
    private static class BehindThePort extends Scenario {
        BehindThePort(String title) {
            super(title + ", behind the port of a phone");
        }

        /** Options of the robot's sound. */
        String[] sound(ConsoleEvent ready) {
            return new String[0];
        }

        @Override
        public RunningProgram robot(String world, String... options) {
            RunningProgram modem = headless(
                    "modem",
                    "simgsm-phone",
                    List.of("--center", centerAddress(), "--number", ROBOT, "--at", "0", "--at-audio", "0"));
            ConsoleEvent ready = modem.expect("ready");
            String port = ready.field("at");
            modem.expect("registered");
            RunningProgram robot = headless(
                    "robot",
                    "simrobot",
                    List.of(
                            "--modem",
                            "127.0.0.1:" + port,
                            "--number",
                            ROBOT,
                            "--world",
                            world(world).toString(),
                            "--answer-after",
                            "0",
                            "--reply",
                            "all"),
                    Stream.of(options, sound(ready)).flatMap(Stream::of).toArray(String[]::new));
            robot.expect("ready");
            robot.expect("registered");
            return robot;
        }
    }

    @Nested
    class TheExample extends ThePapersExampleTest {
        @Override
        Scenario scenario(String title) {
            return new BehindThePort(title);
        }
    }

    @Nested
    class TheExampleInTheSound extends ThePapersExampleTest {
        @Override
        Scenario scenario(String title) {
            return new BehindThePort(title + ", in the sound") {
                @Override
                String[] sound(ConsoleEvent ready) {
                    return new String[] {"--modem-audio", "127.0.0.1:" + ready.field("at-audio")};
                }
            };
        }
    }

    @Nested
    class Tones extends ReplyTonesTest {
        @Override
        Scenario scenario(String title) {
            return new BehindThePort(title);
        }
    }

    @Nested
    class Messages extends ShortMessageOrdersTest {
        @Override
        Scenario scenario(String title) {
            return new BehindThePort(title);
        }
    }
}
