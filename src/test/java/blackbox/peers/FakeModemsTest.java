package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.Dist;
import blackbox.FinishedProgram;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * {@code --modem-check} with the modem profiles that python-gsmmodem-new's tests have recorded from real modems. The profiles
 * accept every command that they do not know, but name no network: the check must find just that.
 */
@Tag("peer")
class FakeModemsTest {
    private static final Path PROFILES = Peer.LIBRARIES.resolve("gsmmodem-tests");

    @ParameterizedTest
    @CsvSource({
        "GenericTestModem, OK, +CPIN: READY OK",
        "WavecomMultiband900E1800, WAVECOM MODEM OK, +CPIN: READY without a result",
        "HuaweiK3715, huawei OK, +CPIN: READY OK",
        "HuaweiE1752, huawei OK, +CPIN: READY OK",
        "QualcommM6280, QUALCOMM INCORPORATED OK, +CPIN: READY OK",
        "ZteK3565Z, ZTE INCORPORATED OK, +CPIN: READY OK",
        "NokiaN79, Nokia OK, +CPIN: READY OK"
    })
    void theProfilesOfRealModemsAreChecked(String profile, String manufacturer, String card) throws Exception {
        Peer.PYTHON.require();
        Peer.require(Files.exists(PROFILES.resolve("fakemodems.py")), "python-gsmmodem-new's tests");
        Process modem = new ProcessBuilder(
                        "python3",
                        Dist.root().resolve("src/test/peers/fake_modem.py").toString(),
                        PROFILES.toString(),
                        profile)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        try (BufferedReader out =
                new BufferedReader(new InputStreamReader(modem.getInputStream(), StandardCharsets.UTF_8))) {
            FinishedProgram check = FinishedProgram.run("simrobot", "--modem-check", "127.0.0.1:" + out.readLine());
            assertEquals(1, check.status(), check.output() + check.error());
            assertTrue(check.output().contains("check command=AT answer=OK verdict=ok\n"), check.output());
            assertTrue(check.output().contains(answer("AT+CGMI", manufacturer)), check.output());
            assertTrue(check.output().contains(answer("AT+CPIN?", card) + " verdict=ok\n"), check.output());
            assertTrue(
                    check.output().endsWith("check command=\"AT+CREG?\" answer=OK verdict=unexpected\n"),
                    check.output());
        } finally {
            modem.destroy();
        }
    }

    private static String answer(String command, String answer) {
        String quoted = answer.equals("OK") ? answer : "\"" + answer + "\"";
        return "check command=" + (command.endsWith("?") ? "\"" + command + "\"" : command) + " answer=" + quoted;
    }
}
