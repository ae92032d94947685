package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A call in a town: phone and robot behind towers, the centre as their controller. */
class TownTest {
    private static final int WEST = 6969;
    private static final int EAST = 6970;

    private static void camp(RunningProgram cells, String tower) {
        cells.expect("camped", "number", Scenario.PHONE, "cell", tower);
    }

    @Test
    void aCallGoesOnWhenThePhoneIsDraggedIntoTheNextCell() throws Exception {
        try (Scenario town = new Scenario("a call is handed over in the village")) {
            town.center();
            RunningProgram cells = town.cells("village.town");
            RunningProgram robot = town.robot("empty.map");
            RunningProgram phone = town.phone(Scenario.PHONE);
            town.call(phone);
            phone.say("press **#**10**");
            phone.expect("tone", "key", "3");

            town.tell("the phone is dragged to the other end of the road");
            cells.say("place " + Scenario.PHONE + " 3200 100");
            cells.expect("handover", "number", Scenario.PHONE, "from", "west", "to", "east", "result", "success");
            ConsoleEvent gap = cells.expect("speech-gap", "number", Scenario.PHONE);
            town.tell("speech gap " + gap.field("millis") + " ms");
            phone.say("press **#**20**");
            phone.expectBefore(Set.of("released"), "tone", "key", "3");
            robot.expect("outcome", "tone", "3");
            robot.expect("outcome", "tone", "3");
            cells.say("mobiles");
            cells.expect("mobile", "number", Scenario.PHONE, "cell", "east", "state", "dedicated");
            phone.say("hangup");
            phone.expectNext("released", "cause", "16");
        }
    }

    @Test
    void inTheTunnelTheCallIsDroppedAndTheRobotStops() throws Exception {
        try (Scenario town = new Scenario("a call is lost in the tunnel")) {
            town.center();
            RunningProgram cells = town.cells("tunnel.town");
            RunningProgram robot = town.robot("empty.map");
            RunningProgram phone = town.phone(Scenario.PHONE);
            town.call(phone);
            phone.say("press **#**9999**");
            robot.expect("status", "value", "Moving");

            cells.say("place " + Scenario.PHONE + " 1800 0");
            cells.expect("radio-link-failure", "number", Scenario.PHONE);
            phone.expect("released");
            robot.expect("released");
            robot.expect("status", "value", "Stopped");

            town.tell("out of the tunnel the phone calls again");
            cells.say("place " + Scenario.PHONE + " 900 0");
            cells.say("mobiles");
            cells.expect("mobile", "number", Scenario.PHONE, "state", "idle");
            town.call(phone);
        }
    }

    @Test
    void thePhonesModemPortNamesTheCellAndItsLevel() throws Exception {
        try (Scenario town = new Scenario("a phone shows its cell")) {
            town.center();
            RunningProgram cells = town.cells("village.town");
            RunningProgram phone = town.phone(Scenario.PHONE, "--at", "0");
            cells.expect("location-update", "number", Scenario.PHONE);
            try (Socket port = connect(phone)) {
                BufferedReader codes =
                        new BufferedReader(new InputStreamReader(port.getInputStream(), StandardCharsets.US_ASCII));
                port.getOutputStream().write("ATE0\rAT+CREG=2;+CREG?\r".getBytes(StandardCharsets.US_ASCII));
                read(codes, "+CREG: 2,1,\"0001\",\"%04X\"".formatted(WEST));
                int near = level(port, codes);

                cells.say("place " + Scenario.PHONE + " 3400 1000");
                camp(cells, "east");
                read(codes, "+CREG: 1,\"0001\",\"%04X\"".formatted(EAST));
                int far = level(port, codes);
                assertTrue(far < near, "near the tower " + near + ", far from it " + far);
            }
        }
    }

    private static Socket connect(RunningProgram phone) throws IOException {
        Socket socket = new Socket(
                InetAddress.getLoopbackAddress(),
                Integer.parseInt(phone.said("ready").field("at")));
        socket.setSoTimeout((int) TimeUnit.SECONDS.toMillis(RunningProgram.PATIENCE_SECONDS));
        return socket;
    }

    /** +CSQ: 0 to 31. */
    private static int level(Socket port, BufferedReader codes) throws IOException {
        port.getOutputStream().write("AT+CSQ\r".getBytes(StandardCharsets.US_ASCII));
        return Integer.parseInt(read(codes, "+CSQ: ").replaceAll("\\+CSQ: (\\d+),.*", "$1"));
    }

    /** The next line that begins so. */
    private static String read(BufferedReader codes, String begin) throws IOException {
        StringBuilder passed = new StringBuilder();
        for (String line = codes.readLine(); line != null; line = codes.readLine()) {
            if (line.startsWith(begin)) {
                return line;
            }
            passed.append(line).append('|');
        }
        throw new AssertionError("no " + begin + " in " + passed);
    }

    @Test
    void aWrongTownFileIsRefusedWithItsLineAndWhatWasExpected(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("wrong.town");
        Files.writeString(file, "town Nowhere\ntower A 0 0 arfcn=20 bsic=70 lac=1\n");

        FinishedProgram refused = FinishedProgram.run("simgsm-cells", "--headless", "--town", file.toString());

        assertEquals(74, refused.status());
        assertEquals("", refused.output());
        assertTrue(refused.error().contains("wrong.town:2: found \"70\", expected bsic, 0 to 63"), refused.error());
    }

    @Test
    void aTownOfTheSuiteIsFoundByItsNameAlone() throws Exception {
        FinishedProgram printed = FinishedProgram.run("simgsm-cells", "--print-osmo-bsc", "--town", "city.town");

        assertEquals(0, printed.status(), printed.error());
        assertTrue(printed.output().contains("radio-link-timeout 16"), printed.output());
    }

    @Test
    void osmoBscGetsTheBandOfEachTowerAndListsThatItWouldEncodeWrongly(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("bands.town");
        Files.writeString(
                file,
                "town Bands\ntower a 0 0 arfcn=975 bsic=1 lac=1\ntower b 9 0 arfcn=600 bsic=2 lac=1\n"
                        + "tower c 9 9 arfcn=800 bsic=3 lac=1\n");

        String printed = FinishedProgram.run("simgsm-cells", "--print-osmo-bsc", "--town", file.toString())
                .output();

        assertEquals(
                List.of("band GSM900", "band DCS1800", "band DCS1800"),
                Pattern.compile("band \\w+")
                        .matcher(printed)
                        .results()
                        .map(MatchResult::group)
                        .toList());
        // Tower a has 600 and 800 in one list of range 256; the others have one frequency of each band, in ascending
        // order.
        assertEquals(1, printed.split("system-information 5 mode static", -1).length - 1, printed);
        assertTrue(printed.contains("system-information 5 static 061d9b2c6400000000000000000000000000"), printed);
    }

    @Test
    void aTowerThatTheCentreRefusesIsToldWithItsReason(@TempDir Path folder) throws Exception {
        StringBuilder town = new StringBuilder("town Many\n");
        for (int i = 0; i < 19; i++) {
            town.append("tower t" + i + " " + 100 * i + " 0 arfcn=" + (512 + 20 * i) + " bsic=1 lac=1\n");
        }
        Path file = Files.writeString(folder.resolve("many.town"), town + "tower west 0 100 arfcn=100 bsic=1 lac=1\n");
        try (Scenario scenario = new Scenario("nineteen towers of one band, and one of another")) {
            scenario.center();
            RunningProgram cells = scenario.cells(file.toString());

            ConsoleEvent refused = cells.expect("cell-refused");

            assertTrue(
                    refused.field("text").startsWith("no frequency list has room for the 19 ARFCNs [512, 532,"),
                    refused.toString());
            cells.say("cells");
            cells.expect("cell", "name", refused.field("name"), "state", "refused");
        }
    }

    /** Towers of one band whose channels are far apart, of both ends of GSM 900, and of two bands. */
    @ParameterizedTest
    @ValueSource(strings = {"600 800", "975 110", "512 885", "100 600"})
    void aCallIsHandedOverThereAndBack(String arfcns, @TempDir Path folder) throws Exception {
        String[] arfcn = arfcns.split(" ");
        Path file = Files.writeString(
                folder.resolve("bands.town"),
                "town Bands\nshadow 0\ntower west 0 0 arfcn=" + arfcn[0] + " bsic=1 lac=1\n"
                        + "tower east 1500 0 arfcn=" + arfcn[1] + " bsic=2 lac=1\n");
        try (Scenario scenario = new Scenario("handover between ARFCNs " + arfcns)) {
            scenario.center("--handover", "strongest-cell,margin=6,reports=1");
            RunningProgram cells = scenario.cells(file.toString());
            cells.say("place " + Scenario.PHONE + " 100 0").say("place " + Scenario.ROBOT + " 100 0");
            RunningProgram robot = scenario.robot("empty.map");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            cells.say("place " + Scenario.PHONE + " 1400 0");
            cells.expect("handover", "from", "west", "to", "east", "result", "success");
            cells.say("place " + Scenario.PHONE + " 100 0");
            cells.expect("handover", "from", "east", "to", "west", "result", "success");
            cells.expect("speech-gap", "number", Scenario.PHONE);
            phone.say("hangup").expect("released", "cause", "16");
            robot.expect("released", "cause", "16");
        }
    }
}
