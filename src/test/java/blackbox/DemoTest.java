package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** The main job: {@code simgsm-center.jar --demo}. */
class DemoTest {
    @Test
    void withoutADisplayTheDemoPlaysASessionAndPrintsItsTranscript() throws Exception {
        FinishedProgram demo = FinishedProgram.run("simgsm-center", "--demo", "--lang", "en");
        assertEquals(0, demo.status(), demo.output() + demo.error());
        for (String shown : new String[] {"1", "6", "3", "4"}) {
            assertTrue(
                    demo.output().lines().anyMatch(line -> line.matches(".*tone.*\\b" + shown + "\\b.*")),
                    "tone " + shown + " in\n" + demo.output());
        }
        assertTrue(demo.output().contains("** #**20 **") || demo.output().contains("**#**20**"), demo.output());
        assertTrue(demo.output().toLowerCase().contains("sms"), demo.output());
        assertTrue(demo.output().contains("Collision"), demo.output());
    }

    @Test
    void theDemosProcessesEndWithTheCentreEvenWhenItIsKilled() throws Exception {
        RunningProgramTree demo = RunningProgramTree.start("simgsm-center", "--demo");
        demo.awaitDescendants(2);
        demo.kill();
        demo.awaitEndOfDescendants();
    }
}
