package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/** A centre that hangs without closing anything takes no call with it for ever. */
class SilentCenterTest {
    private static boolean signal(String name, RunningProgram program) throws IOException, InterruptedException {
        return new ProcessBuilder("kill", "-" + name, String.valueOf(program.pid()))
                        .start()
                        .waitFor()
                == 0;
    }

    @Test
    void bothEndsReleaseACallInWhichNothingComesAnyMore() throws Exception {
        assumeTrue(!System.getProperty("os.name").startsWith("Windows"));
        try (Scenario scenario = new Scenario("the centre hangs in the middle of a call")) {
            RunningProgram center = scenario.center();
            RunningProgram robot = scenario.robot("empty.map");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            assumeTrue(signal("STOP", center), "no kill here");
            try {
                robot.expect("released", "cause", "41");
                ConsoleEvent released = phone.expect("released");
                assertEquals("41", released.field("cause"), "after 10 s without speech");
            } finally {
                signal("CONT", center);
            }
            scenario.tell("the centre is back: what was begun there is cleared, and the next call goes through");
            robot.say("status").expect("status");
            phone.say("dial " + Scenario.ROBOT);
            phone.expect("connected");
        }
    }
}
