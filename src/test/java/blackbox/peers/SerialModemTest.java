package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.FinishedProgram;
import blackbox.RunningProgram;
import blackbox.Scenario;
import blackbox.ServedModem;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A real modem on a serial line: socat makes a pseudo-terminal of the emulated modem's port. */
@Tag("peer")
class SerialModemTest {
    @Test
    void aModemBehindADeviceFileIsCheckedServesAndComesBackWithItsDevice() throws Exception {
        Peer.SOCAT.require();
        try (Scenario scenario = new Scenario("a modem on a serial line");
                ServedModem modem = new ServedModem()) {
            Path device = scenario.folder().resolve("ttyM2");
            Process line = serialLine(scenario, modem.port(), device);
            FinishedProgram check = FinishedProgram.run("simrobot", "--modem-check", device.toString());
            assertEquals(0, check.status(), check.output() + check.error());
            assertTrue(check.output().contains("check command=\"AT+DDET=1,0,1\" answer=OK verdict=ok"), check.output());
            line.destroy();
            line.waitFor();

            line = serialLine(scenario, modem.port(), device);
            RunningProgram robot = scenario.start(
                    "robot",
                    "simrobot",
                    "--headless",
                    "--no-sound",
                    "--lang=en",
                    "--world=" + Scenario.world("empty.map"),
                    "--modem=" + device);
            robot.expect("registered");
            drive(modem, robot);
            scenario.tell("the device vanishes in mid-call");
            line.destroy();
            line.waitFor();
            robot.expect("released", "cause", "41");
            modem.hangUp();
            line = serialLine(scenario, modem.port(), device);
            robot.expect("registered");
            drive(modem, robot);
            assertEquals(0, robot.quit());
        }
    }

    private static void drive(ServedModem modem, RunningProgram robot) {
        modem.call(Scenario.PHONE);
        robot.expect("ringing");
        robot.expect("tone", "key", "1");
        modem.press("** #**20 **");
        robot.expect("tone", "key", "3");
    }

    /** Returns once the device file is there, or fails when socat ends before. */
    static Process serialLine(Scenario scenario, int port, Path device) throws Exception {
        Process socat = scenario.beside(
                new ProcessBuilder("socat", "PTY,link=" + device + ",raw,echo=0", "TCP:127.0.0.1:" + port)
                        .inheritIO()
                        .start());
        while (!Files.exists(device)) {
            assertTrue(socat.isAlive(), "socat has ended");
            socat.waitFor(20, TimeUnit.MILLISECONDS);
        }
        return socat;
    }
}
