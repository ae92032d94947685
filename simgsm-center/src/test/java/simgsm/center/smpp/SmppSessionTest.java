package simgsm.center.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.smpp.SmppClient.text;

import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;

/** Binding, unbinding, and who may do what when. */
class SmppSessionTest extends SmppStage {
    @ParameterizedTest
    @EnumSource(SmppCommand.class)
    void aRequestInTheWrongStateIsAnsweredWithStatus4AndTheMandatoryFields(SmppCommand command) {
        TestCenter.Application open = network.open(true);
        if (command.isBind() || command == SmppCommand.ENQUIRE_LINK || command == SmppCommand.GENERIC_NACK) {
            return;
        }
        SmppPdu pdu = switch (command) {
            case QUERY_SM -> new SmppPdu.Query(5, "1", SmppAddress.NONE);
            case CANCEL_SM -> new SmppPdu.Cancel(5, "", "1", SmppAddress.NONE, SmppAddress.NONE);
            case REPLACE_SM -> new SmppPdu.Replace(5, "1", SmppAddress.NONE, "", "", 0, 0, OctetString.of(new byte[0]));
            case SUBMIT_MULTI -> new SmppPdu.SubmitMulti(5, text("1", "2", "x"), List.of(new SmppAddress(1, 1, "2")));
            case UNBIND -> new SmppPdu.Plain(command, 5);
            default -> new SmppPdu.Message(command, 5, text("1", "2", "x"));
        };
        open.say(pdu);
        byte[] answer = open.lastOctets;
        String body = switch (command) {
            case QUERY_SM -> "3100" + "00" + "07" + "00";
            case SUBMIT_MULTI -> "00" + "00";
            case DATA_SM, DELIVER_SM -> "00";
            default -> "";
        };
        assertEquals(body, HexFormat.of().formatHex(answer, SmppCodec.HEADER_LENGTH, answer.length));
        assertEquals(SmppStatus.INVALID_BIND_STATUS, answer[11]);
        assertEquals(5, answer[15]);
    }

    @Test
    void whoIsBoundCannotBindAgainAndAReceiverCannotSend() {
        TestCenter.Application receiver = receiver(SERVICE);
        receiver.say(new SmppPdu.Bind(SmppCommand.BIND_TRANSMITTER, 2, "x", "", "", 0x34, ""));
        assertEquals(
                SmppStatus.ALREADY_BOUND,
                receiver.last(SmppPdu.BindResponse.class).status());
        receiver.submit(3, text("1", "2", "x"));
        assertEquals(
                SmppStatus.INVALID_BIND_STATUS,
                receiver.last(SmppPdu.MessageResponse.class).status());
    }

    @Test
    void onlyListedApplicationsBindWithTheirPassword() {
        network.server.admit(SmppUsers.only(Map.of("robot", "secret")));
        TestCenter.Application application = network.open(false);
        assertEquals(SmppStatus.INVALID_SYSTEM_ID, bind(application, "nobody", "secret"));
        assertEquals(SmppStatus.INVALID_PASSWORD, bind(application, "robot", "guess"));
        assertFalse(application.hasBound);
        assertEquals(SmppStatus.OK, bind(application, "robot", "secret"));
        assertTrue(application.hasBound, "its address is known from now on");
    }

    @Test
    void withoutAListOnlyThisMachineMayBind() {
        assertEquals(SmppStatus.BIND_FAILED, bind(network.open(false), "robot", ""));
        assertEquals(SmppStatus.OK, bind(network.open(true), "robot", "anything"));
    }

    @Test
    void guessingPasswordsEndsTheConnection() {
        network.server.admit(SmppUsers.only(Map.of("robot", "secret")));
        TestCenter.Application application = network.open(true);
        for (int i = 0; i < EsmeSession.MAX_REFUSED_BINDS; i++) {
            assertFalse(application.isEnding);
            assertEquals(SmppStatus.INVALID_PASSWORD, bind(application, "robot", "guess" + i));
        }
        assertTrue(application.isEnding);
    }

    @ParameterizedTest
    @ValueSource(strings = {"[1-", "[0-9]+", ".*", "*", "555[0-9]{4}", "^555$|^556", "55?", "abc", "1234567890123456"})
    void aRangeThatIsNeitherANumberNorABeginningRefusesTheBind(String range) {
        assertEquals(SmppStatus.BIND_FAILED, bindReceiver(network.open(true), "x", range));
    }

    @ParameterizedTest
    @CsvSource({
        "5550300, 5550300, 55503001",
        "+5550300, 5550300, 55503001",
        "^5550300$, 5550300, 55503001",
        "5550300$, 5550300, 55503001",
        "555.*, 5550300, 5560300",
        "^555.*$, 5550300, 5560300",
        "5553*, 555399, 555299",
        "^5553, 555399, 555299"
    })
    void aRangeIsANumberOrABeginning(String range, String inside, String outside) {
        assertEquals(SmppStatus.OK, bindReceiver(network.open(true), "x", range));
        assertTrue(network.server.routes().serves(new Msisdn(inside)));
        assertFalse(network.server.routes().serves(new Msisdn(outside)));
    }

    @Test
    void aSilentApplicationIsAskedAndThenClosed() {
        TestCenter.Application application = receiver(SERVICE);
        network.passSeconds(60);
        assertEquals(
                SmppCommand.ENQUIRE_LINK, application.last(SmppPdu.Plain.class).command());
        application.say(new SmppPdu.PlainResponse(
                SmppCommand.ENQUIRE_LINK,
                SmppStatus.OK,
                application.last(SmppPdu.Plain.class).sequence()));
        network.passSeconds(59);
        assertEquals("", application.closed);
        network.passSeconds(1);
        network.passSeconds(30);
        assertEquals("does not answer enquire_link", application.closed);
    }

    @Test
    void whoDoesNotBindIsClosed() {
        TestCenter.Application application = network.open(true);
        network.passSeconds(30);
        assertEquals("does not bind", application.closed);
    }

    @Test
    void unbindIsAnsweredAndEndsTheConnection() {
        TestCenter.Application application = receiver(SERVICE);
        application.say(new SmppPdu.Plain(SmppCommand.UNBIND, 9));
        assertEquals(
                new SmppPdu.PlainResponse(SmppCommand.UNBIND, SmppStatus.OK, 9),
                application.last(SmppPdu.PlainResponse.class));
        assertTrue(application.isEnding);
        assertFalse(network.server.routes().serves(new Msisdn(SERVICE)));
    }

    @Test
    void anApplicationElsewhereIsThrottledAndOneHereIsNot() {
        network.server.admit(SmppUsers.only(Map.of("far", "", "near", "")));
        TestCenter.Application far = network.open(false);
        bind(far, "far", "");
        TestCenter.Application near = network.open(true);
        bind(near, "near", "");
        for (int i = 0; i <= RequestLimits.MAX_UNANSWERED; i++) {
            far.submit(i, text("1", SERVICE, "x"));
            near.submit(i, text("1", SERVICE, "x"));
        }
        assertEquals(
                SmppStatus.THROTTLED, far.last(SmppPdu.MessageResponse.class).status());
        assertEquals(1, far.all(SmppPdu.MessageResponse.class).size());
        assertEquals(0, near.all(SmppPdu.MessageResponse.class).size());
    }

    @Test
    void aThousandApplicationsAreHeld() {
        for (int i = 0; i < 1_000; i++) {
            network.bound(SmppCommand.BIND_TRANSCEIVER, "app" + i, "" + (5_000_000 + i));
        }
        assertEquals(1_000, network.server.boundSessions());
        TestCenter.Application sender = sender();
        sender.submit(1, text("1", "5000777", "x"));
        network.commit();
        assertEquals(0, network.center.messages().waiting().size() - 1);
    }
}
