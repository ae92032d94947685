package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The README's headless session works as it stands there, read from a file as fast as the phone can. */
class ReadmeSessionTest {
    private static final Pattern SESSION = Pattern.compile("\n\n((?:    [^\n]+\n)+)", Pattern.DOTALL);

    @Test
    void thePhonesSessionRunsAsAScriptThatDialsBeforeThePhoneIsRegistered() throws Exception {
        try (Scenario scenario = new Scenario("the README's session")) {
            scenario.center();
            scenario.robot("office.map");
            Path script = Files.writeString(scenario.folder().resolve("session.txt"), session());
            RunningProgram phone = scenario.unregisteredPhone(Scenario.PHONE, "--script", script.toString());
            phone.expect("connected", "number", Scenario.ROBOT);
            phone.expect("sent", "keys", "**#**20**");
            phone.expect("released", "cause", "16");
            phone.expect("sms", "from", Scenario.ROBOT);
            assertEquals(0, phone.awaitExit(), phone::toString);
        }
    }

    /** The block of the README that begins by dialling. */
    private static String session() throws IOException {
        Matcher block = SESSION.matcher(Files.readString(Dist.root().resolve("README.md")));
        while (block.find()) {
            String lines = block.group(1).indent(-4);
            if (lines.startsWith("dial ")) {
                return lines;
            }
        }
        throw new AssertionError("the README has no session that dials");
    }
}
