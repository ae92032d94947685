package simgsm.center.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.smpp.SmppClient.bound;
import static simgsm.center.smpp.SmppClient.message;
import static simgsm.center.smpp.SmppClient.text;
import static simgsm.center.smpp.SmppClient.with;
import static simgsm.center.smpp.SmppClient.withReceipt;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeSettings;
import simgsm.center.net.CenterLoop;
import simgsm.center.net.PortLimits;
import simgsm.center.smsc.MessageStore;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.Tlv;

/** The whole way over loopback sockets, as a client of another house would try it. */
@Timeout(60)
class SmppOverSocketsTest {
    private static final String SERVICE = "5550300";

    private final SmppServer smpp = new SmppServer();
    private CenterLoop loop;
    private int port;

    @BeforeEach
    void open() throws IOException {
        loop = CenterLoop.open(InetAddress.getLoopbackAddress(), 0, PortLimits.STANDARD);
        port = loop.openSmpp(InetAddress.getLoopbackAddress(), 0, smpp);
        MessageStore store = (ticket, entries) -> loop.post(owned -> owned.committed(loop.nowNanos(), ticket, true));
        Exchange exchange =
                new Exchange(new ExchangeSettings("SimGSM", 1, Instant.EPOCH), store, smpp.routes(), event -> {});
        smpp.serve(exchange.shortMessages(), exchange.timers());
        loop.start(exchange, cause -> {});
    }

    @AfterEach
    void close() {
        loop.close();
    }

    private SmppClient transceiver() throws IOException {
        return bound(port, SmppCommand.BIND_TRANSCEIVER, "app", SERVICE);
    }

    private static byte[] hex(String octets) {
        return HexFormat.of().parseHex(octets.replace(" ", ""));
    }

    /** The centre still serves new connections. */
    private void assertServes() throws IOException {
        try (SmppClient client = transceiver()) {
            client.submitted(text("1", SERVICE, "still there"));
        }
    }

    @ParameterizedTest
    @EnumSource(
            value = SmppCommand.class,
            names = {"BIND_RECEIVER", "BIND_TRANSMITTER", "BIND_TRANSCEIVER"})
    void bindIsAnsweredWithTheCentresNameAndVersion(SmppCommand command) throws IOException {
        try (SmppClient client = new SmppClient(port)) {
            client.send(new SmppPdu.Bind(command, 77, "app", "secret", "", 0x34, ""));
            assertEquals(new SmppPdu.BindResponse(command, 0, 77, "SimGSM"), client.read());
        }
    }

    @Test
    void theSameIdBindsSeveralTimes() throws IOException {
        try (SmppClient first = transceiver();
                SmppClient second = transceiver()) {
            first.submitted(text("1", SERVICE, "x"));
            second.submitted(text("1", SERVICE, "x"));
        }
    }

    @Test
    void aMessageGoesRoundAndItsReceiptComesBack() throws IOException {
        try (SmppClient client = transceiver()) {
            String id = client.submitted(withReceipt(text("5550300", SERVICE, "to myself")));
            assertEquals("to myself", new String(client.take().shortMessage().toArray(), StandardCharsets.US_ASCII));
            SmppMessage receipt = client.take();
            String words = new String(receipt.shortMessage().toArray(), StandardCharsets.US_ASCII);
            assertTrue(
                    words.matches("id:" + id + " sub:001 dlvrd:001 submit date:\\d{10} done date:\\d{10}"
                            + " stat:DELIVRD err:000 text:to myself"),
                    words);
            assertEquals(2, receipt.parameter(Tlv.MESSAGE_STATE).orElseThrow().toArray()[0]);
        }
    }

    @Test
    void idsDiffer() throws IOException {
        try (SmppClient client = transceiver()) {
            assertNotEquals(client.submitted(text("1", "2", "x")), client.submitted(text("1", "2", "x")));
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 1b654142", "3, 4772fcdf65", "4, 00ff1080", "8, 00e94e2dd83dde00"})
    void everyCodingArrivesAsItWasSent(int dataCoding, String octets) throws IOException {
        try (SmppClient client = transceiver()) {
            client.submitted(message("1", SERVICE, 0, dataCoding, hex(octets)));
            SmppMessage taken = client.take();
            assertEquals(octets, taken.shortMessage().toString());
            assertEquals(dataCoding, taken.dataCoding());
        }
    }

    @Test
    void aPayloadParameterCarriesALongText() throws IOException {
        try (SmppClient client = transceiver();
                SmppClient sender = bound(port, SmppCommand.BIND_TRANSMITTER, "sender", "")) {
            Tlv payload =
                    new Tlv(Tlv.MESSAGE_PAYLOAD, OctetString.of("y".repeat(400).getBytes(StandardCharsets.US_ASCII)));
            sender.submitted(with(text("1", SERVICE, ""), "", 0, List.of(payload)));
            int octets = 0;
            for (int i = 0; i < 3; i++) {
                SmppMessage part = client.take();
                assertTrue(part.hasHeader());
                octets += part.shortMessage().length() - 6;
            }
            assertEquals(400, octets);
        }
    }

    @Test
    void dataSmIsTakenToo() throws IOException {
        try (SmppClient client = transceiver()) {
            Tlv payload = new Tlv(Tlv.MESSAGE_PAYLOAD, OctetString.ofHex("414243"));
            client.send(
                    new SmppPdu.Message(SmppCommand.DATA_SM, 9, with(text("1", SERVICE, ""), "", 0, List.of(payload))));
            assertEquals(
                    SmppCommand.DATA_SM,
                    client.read(SmppPdu.MessageResponse.class).command());
            assertEquals("414243", client.take().shortMessage().toString());
        }
    }

    @Test
    void enquireLinkIsAnswered() throws IOException {
        try (SmppClient client = transceiver()) {
            client.send(new SmppPdu.Plain(SmppCommand.ENQUIRE_LINK, 42));
            assertEquals(new SmppPdu.PlainResponse(SmppCommand.ENQUIRE_LINK, 0, 42), client.read());
        }
    }

    @Test
    void unbindIsAnsweredAndThenTheConnectionCloses() throws IOException {
        try (SmppClient client = transceiver()) {
            client.send(new SmppPdu.Plain(SmppCommand.UNBIND, 43));
            assertEquals(new SmppPdu.PlainResponse(SmppCommand.UNBIND, 0, 43), client.read());
            client.awaitEnd();
        }
        assertServes();
    }

    @Test
    void anUnknownCommandGetsGenericNackAndTheSessionGoesOn() throws IOException {
        try (SmppClient client = transceiver()) {
            client.write(hex("00000010 00000077 00000000 0000002c"));
            assertEquals(new SmppPdu.GenericNack(SmppStatus.INVALID_COMMAND_ID, 44), client.read());
            client.submitted(text("1", SERVICE, "goes on"));
        }
    }

    @ParameterizedTest
    @CsvSource({"0000000f", "00000000", "7fffffff", "ffffffff", "00100000"})
    void aLengthThatCannotBeGetsGenericNackAndTheEnd(String length) throws IOException {
        try (SmppClient client = transceiver()) {
            client.write(hex(length + "00000004 00000000 0000002d"));
            assertEquals(new SmppPdu.GenericNack(SmppStatus.INVALID_COMMAND_LENGTH, 45), client.read());
            client.awaitEnd();
        }
        assertServes();
    }

    @Test
    void aBodyThatIsCutShortIsRefusedWithItsStatus() throws IOException {
        try (SmppClient client = transceiver()) {
            byte[] whole = SmppCodec.encode(new SmppPdu.Message(SmppCommand.SUBMIT_SM, 5, text("1", SERVICE, "hello")));
            for (int length = 16; length < whole.length; length++) {
                byte[] cut = Arrays.copyOf(whole, length);
                cut[2] = 0;
                cut[3] = (byte) length;
                client.write(cut);
                int status = client.read(SmppPdu.MessageResponse.class).status();
                assertTrue(
                        status == SmppStatus.INVALID_COMMAND_LENGTH || status == SmppStatus.INVALID_MESSAGE_LENGTH,
                        length + " octets: status " + status);
            }
            client.submitted(text("1", SERVICE, "goes on"));
        }
    }

    @ParameterizedTest
    @CsvSource({"1, abc, 0x0b", "1, '', 0x0b", "1, 1234567890123456, 0x0b", "muchTooLongName, 5550300, 0x0a"})
    void addressesThatAreNoneAreRefused(String from, String to, String status) throws IOException {
        try (SmppClient client = transceiver()) {
            assertEquals(
                    Integer.decode(status), client.submit(text(from, to, "x")).status());
        }
    }

    @Test
    void aSenderMayHaveAName() throws IOException {
        try (SmppClient client = transceiver()) {
            client.submitted(text("RoboShop", SERVICE, "x"));
            SmppAddress source = client.take().source();
            assertEquals(new SmppAddress(5, 0, "RoboShop"), source);
        }
    }

    @Test
    void aWindowOfSubmissionsIsAnsweredInOrder() throws IOException {
        try (SmppClient client = bound(port, SmppCommand.BIND_TRANSMITTER, "app", "")) {
            for (int i = 1; i <= 500; i++) {
                client.send(new SmppPdu.Message(SmppCommand.SUBMIT_SM, i, text("1", "9", "x")));
            }
            for (int i = 1; i <= 500; i++) {
                assertEquals(i, client.read(SmppPdu.MessageResponse.class).sequence());
            }
        }
    }

    @Test
    void octetsMayComeOneByOne() throws IOException {
        try (SmppClient client = new SmppClient(port)) {
            byte[] bind = SmppCodec.encode(new SmppPdu.Bind(SmppCommand.BIND_TRANSMITTER, 1, "a", "b", "", 0x34, ""));
            for (byte octet : bind) {
                client.write(new byte[] {octet});
            }
            assertEquals(0, client.read(SmppPdu.BindResponse.class).status());
        }
    }

    @Test
    void anApplicationThatDoesNotReadDelaysNoOther() throws IOException {
        try (SmppClient deaf = transceiver();
                SmppClient other = bound(port, SmppCommand.BIND_TRANSCEIVER, "other", "5550301")) {
            for (int i = 0; i < 500; i++) {
                other.submitted(text("1", SERVICE, "x".repeat(150)));
            }
            other.submitted(text("1", "5550301", "for me"));
            assertEquals("for me", new String(other.take().shortMessage().toArray(), StandardCharsets.US_ASCII));
            deaf.send(new SmppPdu.Plain(SmppCommand.UNBIND, 1));
        }
        assertServes();
    }

    @Test
    void nonsenseEndsAtItsOwnConnection() throws IOException {
        SplittableRandom random = new SplittableRandom(4);
        byte[] whole = SmppCodec.encode(new SmppPdu.Message(SmppCommand.SUBMIT_SM, 5, text("1", SERVICE, "hello")));
        for (int i = 0; i < 200; i++) {
            try (SmppClient client = transceiver()) {
                byte[] mutated = whole.clone();
                for (int change = 0; change < 4; change++) {
                    mutated[4 + random.nextInt(mutated.length - 4)] = (byte) random.nextInt();
                }
                client.write(mutated);
                client.write(SmppCodec.encode(new SmppPdu.Plain(SmppCommand.ENQUIRE_LINK, 1)));
                client.read(SmppPdu.PlainResponse.class);
            }
        }
        assertServes();
    }

    @Test
    void aThousandSessionsAreHeldAndServed() throws IOException {
        List<SmppClient> clients = new ArrayList<>();
        try {
            for (int i = 0; i < 1_000; i++) {
                clients.add(bound(port, SmppCommand.BIND_TRANSCEIVER, "app" + i, "" + (6_000_000 + i)));
            }
            for (int i = 0; i < 1_000; i += 111) {
                clients.get(0).submitted(text("1", "" + (6_000_000 + i), "x"));
                if (i > 0) {
                    assertEquals(
                            "" + (6_000_000 + i),
                            clients.get(i).take().destination().value());
                }
            }
        } finally {
            for (SmppClient client : clients) {
                client.close();
            }
        }
        assertServes();
    }

    @Test
    void onlyListedUsersBind() throws IOException {
        loop.post(exchange -> smpp.admit(SmppUsers.only(Map.of("app", "secret"))));
        try (SmppClient client = new SmppClient(port)) {
            assertEquals(SmppStatus.INVALID_SYSTEM_ID, client.bind(SmppCommand.BIND_TRANSMITTER, "me", "secret", ""));
            assertEquals(SmppStatus.INVALID_PASSWORD, client.bind(SmppCommand.BIND_TRANSMITTER, "app", "wrong", ""));
            assertEquals(SmppStatus.OK, client.bind(SmppCommand.BIND_TRANSMITTER, "app", "secret", ""));
            assertEquals(SmppStatus.ALREADY_BOUND, client.bind(SmppCommand.BIND_TRANSMITTER, "app", "secret", ""));
        }
    }
}
