package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.RunningProgram;
import blackbox.Scenario;
import java.io.IOException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Clients from elsewhere begin while the server is stopped for 1.5 s, as on a busy machine, and are served afterwards. */
@Tag("peer")
class StoppedServerTest {
    static void stop(RunningProgram server) throws IOException, InterruptedException {
        new ProcessBuilder("kill", "-STOP", String.valueOf(server.pid()))
                .start()
                .waitFor();
        new ProcessBuilder("sh", "-c", "sleep 1.5; kill -CONT " + server.pid()).start();
    }

    @Test
    void smpplibBindsAndSubmits() throws Exception {
        Peer.require(Peer.PYTHON.run("-c", "import smpplib").status() == 0, "smpplib (Python)");
        try (Scenario scenario = new Scenario("smpplib meets a stopped centre")) {
            RunningProgram center = scenario.center("--smpp", "0");
            scenario.robot("empty.map", "--speed", "20");
            stop(center);
            String printed = Peer.PYTHON
                    .run(
                            Peer.source("smpplib_order.py"),
                            String.valueOf(scenario.smppPort()),
                            "5550300",
                            Scenario.ROBOT,
                            "** #**20 **")
                    .expectSuccess();
            assertTrue(printed.contains("reply 3 Done: #**20."), printed);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "socat, printf 'AT\\r' | socat -t 20 - TCP:127.0.0.1:PORT",
        "gammu, 'socat PTY,link=tty,raw,echo=0,wait-slave TCP:127.0.0.1:PORT & "
                + "until [ -e tty ]; do sleep 0.1; done; printf \"[gammu]\\ndevice = tty\\nconnection = at115200\\n\" > rc; "
                + "gammu -c rc identify && echo OK'",
    })
    void aClientOfTheAtPortIsAnswered(String client, String script) throws Exception {
        Peer.SOCAT.require();
        Peer.require(Peer.BASH.run("-c", "command -v " + client).status() == 0, client);
        try (Scenario scenario = new Scenario(client + " meets a stopped SimRobot")) {
            RunningProgram robot =
                    scenario.start("robot", "simrobot", "--headless", "--center", "127.0.0.1:1", "--at", "0");
            String port = robot.expect("ready").field("at");
            stop(robot);
            String printed = Peer.run(Peer.BASH
                            .process("-c", script.replace("PORT", port))
                            .directory(scenario.folder().toFile()))
                    .expectSuccess();
            assertTrue(printed.contains("OK"), printed);
        }
    }
}
