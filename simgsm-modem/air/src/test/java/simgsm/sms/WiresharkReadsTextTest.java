package simgsm.sms;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.abis.RslMessage;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Msisdn;
import simgsm.air.PcapFile;
import simgsm.air.RelayMessage;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.air.Tshark;
import simgsm.octets.OctetString;

/** What a foreign reader finds in our short messages and broadcast pages. */
@Tag("peer")
class WiresharkReadsTextTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"** #**20 ** ñ€{}", "Avanza á la derecha", "移动 robot"})
    void theTextOfEveryPartIsRead(String text) throws Exception {
        List<UserData> parts = MessageSplitter.split(text.repeat(9), 0x2a);
        PcapFile file = new PcapFile();
        for (UserData part : parts) {
            file.add(cpData(SubmitTpdu.of(1, TpduExamples.BOB, part), Direction.UPLINK), Direction.UPLINK);
        }

        List<String> lines = Tshark.fields(file, folder, "_ws.malformed", "_ws.expert.message", "gsm_sms.sms_text");

        assertEquals(parts.size(), lines.size());
        assertTrue(parts.size() > 1);
        for (int i = 0; i < parts.size(); i++) {
            assertTrue(lines.get(i).startsWith("||"), lines.get(i));
        }
        // A whole text may be shown again with its last part.
        assertEquals("||" + parts.get(0).text(), lines.get(0));
    }

    @Test
    void everyUnitIsFine() throws Exception {
        PcapFile file = new PcapFile();
        for (TpduExamples.Example example : TpduExamples.ALL) {
            file.add(cpData(example.tpdu(), example.direction()), example.direction());
        }

        List<String> lines = Tshark.fields(file, folder, "_ws.malformed", "_ws.expert.message", "_ws.col.Info");

        assertEquals(TpduExamples.ALL.size(), lines.size());
        lines.forEach(line -> assertTrue(line.startsWith("||") && line.contains("RP-DATA"), line));
    }

    /** A language in front of the text is left out here: Wireshark shows it as text. */
    @ParameterizedTest
    @CsvSource({"'', The robot is moving.", "es, El robot se mueve.", "'', Atención: 移动."})
    void broadcastTextIsRead(String language, String sentence) throws Exception {
        String text = (sentence + " ").repeat(8);
        PcapFile file = new PcapFile();
        List<CellBroadcastPage> pages = CellBroadcast.split(
                text, 50, new BroadcastSerial(1, 1, 0), Optional.of(language).filter(each -> !each.isEmpty()));
        for (CellBroadcastPage page : pages) {
            file.add(frame(new RslMessage.SmsBroadcastCommand(page.encode())), Direction.DOWNLINK);
        }

        List<String> lines = Tshark.fields(
                file, folder, "_ws.malformed", "_ws.expert.message", "gsm_cbs.total_pages", "gsm_cbs.page_content");

        assertEquals(pages.size(), lines.size());
        String clean = "||" + pages.size() + "|";
        lines.forEach(line -> assertTrue(line.startsWith(clean), line));
        assertEquals(
                text, lines.stream().map(line -> line.substring(clean.length())).collect(Collectors.joining()));
    }

    private static byte[] cpData(Tpdu tpdu, Direction direction) {
        RelayMessage relay = new RelayMessage.RpData(1, Msisdn.parse("+491700000000"), TpduCodec.encode(tpdu));
        ShortMessageControl message = new ShortMessageControl.CpData(new TransactionIdentifier(0, false), relay);
        OctetString layer3 = OctetString.of(Layer3Codec.encode(message, direction, 0));
        return frame(
                direction == Direction.UPLINK
                        ? new RslMessage.DataIndication(RslMessage.Sapi.SHORT_MESSAGES, layer3)
                        : new RslMessage.DataRequest(RslMessage.Sapi.SHORT_MESSAGES, layer3));
    }

    private static byte[] frame(RslMessage message) {
        return IpaFramer.encode(new IpaFrame(IpaFrame.RSL, message.encode()));
    }
}
