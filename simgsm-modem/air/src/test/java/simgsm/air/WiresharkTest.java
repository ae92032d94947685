package simgsm.air;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.abis.RslMessage;
import simgsm.air.Examples.Example;
import simgsm.octets.OctetString;

/** What Wireshark makes of our frames when it has not been told anything. Skipped where tshark is not installed. */
@Tag("peer")
class WiresharkTest {
    private static final Direction UP = Direction.UPLINK;
    private static final Direction DOWN = Direction.DOWNLINK;

    @TempDir
    Path folder;

    @Test
    void everyLayer3MessageIsNamedAndNothingIsWrong() throws Exception {
        PcapFile file = new PcapFile();
        for (Example example : Examples.all()) {
            file.add(rsl(inRsl(example)), example.direction());
        }

        assertNamedInOrder(
                dissect(file),
                Examples.all().stream()
                        .map(example -> Layer3Type.of(example.message()).title())
                        .toArray(String[]::new));
    }

    @Test
    void everyOtherFrameIsNamedAndNothingIsWrong() throws Exception {
        PcapFile file = new PcapFile();
        file.add(ccm(new CcmMessage.IdentityRequest()), DOWN);
        file.add(ccm(new CcmMessage.IdentityResponse("SimGSM phone", "490154203237518")), UP);
        file.add(ccm(new CcmMessage.IdentityAcknowledge()), DOWN);
        file.add(ccm(new CcmMessage.Ping()), UP);
        file.add(ccm(new CcmMessage.Pong()), DOWN);
        file.add(rsl(new RslMessage.PagingCommand(Examples.IMSI)), DOWN);
        file.add(rsl(new RslMessage.PagingCommand(Examples.TMSI)), DOWN);
        file.add(rsl(new RslMessage.ReleaseIndication(RslMessage.Sapi.SIGNALLING)), UP);
        file.add(rsl(new RslMessage.ErrorIndication(RslMessage.Sapi.SHORT_MESSAGES, 1)), UP);

        assertNamedInOrder(
                dissect(file),
                "IDENTITY REQUEST",
                "IDENTITY RESPONSE",
                "IDENTITY ACK",
                "PING",
                "PONG",
                "PAGING CoMmanD",
                "PAGING CoMmanD",
                "RELease INDication",
                "ERROR INDication");
    }

    @Test
    void numbersOfEveryLengthAreFine() throws Exception {
        PcapFile file = new PcapFile();
        String digits = "555010012345678";
        for (int length = 1; length <= Msisdn.MAX_DIGITS; length++) {
            Msisdn number = new Msisdn(digits.substring(0, length));
            file.add(
                    rsl(establish(new CallControl.Setup(Examples.ours(0), Optional.empty(), Optional.of(number)))), UP);
            file.add(
                    rsl(request(new CallControl.Setup(Examples.ours(0), Optional.of(number), Optional.of(number)))),
                    DOWN);
        }

        List<String> lines = dissect(file);

        assertEquals(2 * Msisdn.MAX_DIGITS, lines.size());
        lines.forEach(line -> assertNamed(line, "Setup"));
    }

    @Test
    void identitiesOfEveryLengthAreFine() throws Exception {
        PcapFile file = new PcapFile();
        for (int length = 6; length <= 15; length++) {
            Imsi imsi = new Imsi("001010000000001".substring(0, length));
            file.add(rsl(establish(new RadioResource.PagingResponse(7, imsi))), UP);
        }

        List<String> lines = dissect(file);

        assertEquals(10, lines.size());
        lines.forEach(line -> assertNamed(line, "Paging Response"));
    }

    private static RslMessage establish(Layer3Message message) {
        OctetString layer3 = OctetString.of(Layer3Codec.encode(message, UP, 0));
        return new RslMessage.EstablishIndication(RslMessage.Sapi.SIGNALLING, layer3);
    }

    private static RslMessage request(Layer3Message message) {
        OctetString layer3 = OctetString.of(Layer3Codec.encode(message, DOWN, 0));
        return new RslMessage.DataRequest(RslMessage.Sapi.SIGNALLING, layer3);
    }

    private static void assertNamedInOrder(List<String> lines, String... names) {
        assertEquals(names.length, lines.size());
        for (int i = 0; i < names.length; i++) {
            assertNamed(lines.get(i), names[i]);
        }
    }

    private static void assertNamed(String line, String name) {
        assertAll(
                () -> assertTrue(
                        line.toLowerCase().contains(name.toLowerCase()), () -> "\"" + name + "\" in \"" + line + "\""),
                () -> assertClean(line));
    }

    private static void assertClean(String line) {
        assertTrue(!line.contains("Malformed") && line.endsWith("||"), () -> "nothing wrong in " + line);
    }

    private static RslMessage inRsl(Example example) {
        OctetString layer3 = OctetString.of(example.octets());
        RslMessage.Sapi sapi = example.message() instanceof ShortMessageControl
                ? RslMessage.Sapi.SHORT_MESSAGES
                : RslMessage.Sapi.SIGNALLING;
        return example.direction() == UP
                ? new RslMessage.DataIndication(sapi, layer3)
                : new RslMessage.DataRequest(sapi, layer3);
    }

    private static byte[] rsl(RslMessage message) {
        return IpaFramer.encode(new IpaFrame(IpaFrame.RSL, message.encode()));
    }

    private static byte[] ccm(CcmMessage message) {
        return IpaFramer.encode(new IpaFrame(IpaFrame.CCM, CcmCodec.encode(message)));
    }

    /** One line a packet: protocol, the Info column, expert messages and malformed marks, empty if all is well. */
    private List<String> dissect(PcapFile file) throws IOException, InterruptedException {
        return Tshark.fields(file, folder, "_ws.col.Protocol", "_ws.col.Info", "_ws.expert.message", "_ws.malformed");
    }
}
