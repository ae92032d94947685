package simgsm.center.bsc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslElement;
import simgsm.abis.RslType;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.subscriber.HomeRegister;
import simgsm.octets.OctetString;
import simgsm.sim.GsmVector;
import simgsm.sim.SimCard;
import simgsm.sim.Subscription;

/** A closed network over towers, where a mobile may name the identity of another. */
class TowerAuthenticationTest {
    private static final SimCard ANA = card("5550100", 1);
    private static final SimCard EVA = card("5550200", 2);
    private static final String SERVICE = "0524 14 03331981 05f4";

    private final TowerStage stage = new TowerStage(
            HomeRegister.closed(List.of(new Subscription(ANA, false), new Subscription(EVA, false)), List.of()));
    private final TestTower west = stage.west();
    private String tmsiOfEva;

    private static SimCard card(String number, int key) {
        OctetString k = OctetString.ofHex(String.format("%032x", key));
        return new SimCard(Imsi.ofOpenNumber(new Msisdn(number)), new Msisdn(number), k, k);
    }

    /** Answers the challenge that must come next. @param header of the answer, with its sequence number */
    private void prove(SimCard card, String channel, String header) {
        String request = west.nextLayer3();
        assertTrue(request.startsWith("0512"), request);
        OctetString rand = OctetString.ofHex(request.substring(6));
        GsmVector vector = card.vector(rand);
        west.tell(channel, header + vector.sres());
        String command = "082601" + channel + "070902" + vector.kc() + "02000b0003063501";
        if (west.received.remove(OctetString.ofHex(command))) {
            west.tell(channel, "0632");
        }
    }

    private String register(SimCard card, String imei) {
        String channel = west.access(
                "05", "0508 70 00f110 fffe 33 " + TestTower.imsi(card.number().digits()));
        prove(card, channel, "0554");
        assertEquals("051802", west.nextLayer3());
        west.tell(channel, "0519 08 " + imei);
        String accept = west.nextLayer3();
        west.tell(channel, "055b");
        west.leave(channel);
        return accept.substring(accept.length() - 8);
    }

    @Test
    void aCardWithItsKeyIsCipheredBeforeItsServiceAndStaysSoOnATrafficChannel() {
        register(EVA, TowerStage.OTHER_IMEI);
        String tmsi = register(ANA, TowerStage.IMEI);
        String channel = west.access("e1", SERVICE.replace("0524 14", "0524 11").replace("981", "982") + tmsi);
        String request = west.nextLayer3();
        GsmVector vector = ANA.vector(OctetString.ofHex(request.substring(6)));
        west.tell(channel, "0554" + vector.sres());
        // a phone that has A5/3
        OctetString information = OctetString.ofHex("04" + vector.kc());
        assertEquals(
                information,
                west.next(RslType.ENCRYPTION_COMMAND)
                        .find(RslElement.ENCRYPTION_INFORMATION)
                        .orElseThrow());
        assertTrue(west.received.isEmpty(), "no service before ciphering");
        west.tell(channel, "0632");
        assertTrue(west.received.isEmpty(), "ciphering accepts the service");
        west.tell(channel, TowerCalls.SETUP.replace("0345", "0305"));
        assertEquals(
                information,
                west.next(RslType.CHANNEL_ACTIVATION)
                        .find(RslElement.ENCRYPTION_INFORMATION)
                        .orElseThrow());
    }

    /** As of COMP128 version 2 in place of 3: SRES is right, the key is not, so the tower cannot read the answer. */
    @Test
    void aMobileWithAWrongKeyIsReleasedAndRegistersWhenItsKeyIsRight() {
        String channel = west.access("05", "0508 70 00f110 fffe 33 " + TestTower.imsi("5550100"));
        String request = west.nextLayer3();
        GsmVector vector = ANA.vector(OctetString.ofHex(request.substring(6)));
        west.tell(channel, "0554" + vector.sres());
        assertEquals(
                OctetString.ofHex("02" + vector.kc()),
                west.next(RslType.ENCRYPTION_COMMAND)
                        .find(RslElement.ENCRYPTION_INFORMATION)
                        .orElseThrow());
        stage.passMillis(12_000);
        assertEquals("060d00", west.nextLayer3());
        assertEquals(List.of(), attachedOrDetached());
        west.leave(channel);
        register(ANA, TowerStage.IMEI);
        assertEquals(List.of(new ExchangeEvent.Attached(ANA.number())), attachedOrDetached());
    }

    /** Classmark 1 with the bit that says that A5/1 is not available. */
    @Test
    void aMobileWithoutAnAlgorithmIsServedInTheClear() {
        String channel = west.access("05", "0508 70 00f110 fffe 3b " + TestTower.imsi("5550100"));
        String request = west.nextLayer3();
        west.tell(
                channel,
                "0554" + ANA.vector(OctetString.ofHex(request.substring(6))).sres());
        assertEquals("051802", west.nextLayer3());
    }

    @Test
    void aMobileThatNamesAnothersIdentityAndKeyNumberIsChallengedAndTheOtherStaysAttached() {
        String tmsi = register(ANA, TowerStage.IMEI);

        String channel = west.access("11", SERVICE + tmsi);
        prove(EVA, channel, "0554");

        assertEquals("0511", west.nextLayer3());
        assertEquals("060d00", west.nextLayer3());
        assertEquals(List.of(new ExchangeEvent.Attached(ANA.number())), stage.events);
    }

    @Test
    void aCardThatAnswersThePagingOfAnotherGetsNoMessage() {
        String answer = answerPaging();
        prove(ANA, answer, "0514");

        assertEquals("0511", west.nextLayer3());
        assertFalse(isSapi3Opened(answer));
    }

    @Test
    void theCardThatIsPagedGetsItsMessageAfterAChallenge() {
        String answer = answerPaging();
        prove(EVA, answer, "0514");

        assertTrue(isSapi3Opened(answer), west.received.toString());
    }

    @Test
    void anIntruderThatNamesAMobileInAConnectionDoesNotEndThatConnection() {
        String tmsi = register(ANA, TowerStage.IMEI);
        register(EVA, TowerStage.OTHER_IMEI);
        String own = beginService(ANA, tmsi);

        String other = west.access("11", SERVICE + tmsi);
        west.received.clear();
        west.tell(own, "0305 0406600402000581 5e0581550502f0");
        assertEquals("8302", west.nextLayer3());
        west.tell(other, "0554 00000000");

        assertEquals("0511", west.nextLayer3());
        west.received.clear();
        west.tell(own, "0365 02e090");
        assertEquals("832d", west.nextLayer3().substring(0, 4));
        assertEquals(2, stage.exchange.attachedCount());
    }

    @Test
    void aMobileThatComesBackAfterItLostItsChannelProvesItselfAndEndsItsOldConnection() {
        String tmsi = register(ANA, TowerStage.IMEI);
        String old = beginService(ANA, tmsi);

        String channel = west.access("11", SERVICE + tmsi);
        prove(ANA, channel, "0554");

        west.down("082501" + old, "082e01" + old);
        west.tell(channel, "0305 0406600402000581 5e0581550502f0");
        assertEquals("8302", west.nextLayer3());
        assertEquals(1, stage.exchange.linkCount());
    }

    @Test
    void aMobileThatIsPagedWhileAnIntruderIsChallengedInItsNameGetsItsMessage() {
        String sender = register(ANA, TowerStage.IMEI);
        String receiver = register(EVA, TowerStage.OTHER_IMEI);
        String intruder = west.access("11", SERVICE + receiver);
        submit(beginService(ANA, sender));
        assertFalse(isSapi3Opened(intruder));
        west.next(RslType.PAGING_COMMAND);

        String answer = west.access("91", "0627 07 03331981 05f4" + receiver);
        prove(EVA, answer, "0514");

        assertTrue(isSapi3Opened(answer), west.received.toString());
    }

    @Test
    void anIntruderThatAnswersAPagingDoesNotEndIt() {
        String intruder = answerPaging();
        prove(ANA, intruder, "0514");
        west.leave(intruder);
        stage.passMillis(1_000);
        west.next(RslType.PAGING_COMMAND);

        String answer = west.access("91", "0627 07 03331981 05f4" + tmsiOfEva);
        prove(EVA, answer, "0514");

        assertTrue(isSapi3Opened(answer), west.received.toString());
    }

    @Test
    void aDetachThatNamesAMobileInAConnectionDoesNotEndIt() {
        String tmsi = register(ANA, TowerStage.IMEI);
        beginService(ANA, tmsi);

        west.access("11", "0501 33 05f4" + tmsi);

        assertEquals(List.of(new ExchangeEvent.Attached(ANA.number())), attachedOrDetached());
    }

    @Test
    void aMobileThatDetachesIsForgottenWithItsConnection() {
        String tmsi = register(ANA, TowerStage.IMEI);

        String channel = west.access("11", "0501 33 05f4" + tmsi);
        prove(ANA, channel, "0554");
        assertEquals("060d00", west.nextLayer3());
        stage.passMillis(10);
        west.leave(channel);

        assertEquals(0, stage.exchange.attachedCount());
        assertEquals(0, stage.exchange.linkCount());
    }

    @Test
    void anIntruderThatNamesAMobileDoesNotDetachIt() {
        String tmsi = register(ANA, TowerStage.IMEI);

        String channel = west.access("11", "0501 33 05f4" + tmsi);
        prove(EVA, channel, "0554");

        assertEquals("0511", west.nextLayer3());
        assertEquals("060d00", west.nextLayer3());
        assertEquals(List.of(new ExchangeEvent.Attached(ANA.number())), attachedOrDetached());
    }

    private List<ExchangeEvent> attachedOrDetached() {
        return stage.events.stream()
                .filter(event -> event instanceof ExchangeEvent.Attached || event instanceof ExchangeEvent.Detached)
                .toList();
    }

    /** Up to CM SERVICE ACCEPT. @return the channel */
    private String beginService(SimCard card, String tmsi) {
        String channel = west.access("11", SERVICE + tmsi);
        prove(card, channel, "0554");
        // ciphering accepts the service
        return channel;
    }

    /** A message for 5550200. */
    private void submit(String channel) {
        west.up("0206 01" + channel + "0203");
        west.tellSms(channel, "3901 17 00 01 00 0291f1 10 1101 0781 550502f0 0000 a7 04 f4f29c0e");
    }

    /** A message from the first card for the second, whose paging is answered. @return the channel */
    private String answerPaging() {
        String sender = register(ANA, TowerStage.IMEI);
        tmsiOfEva = register(EVA, TowerStage.OTHER_IMEI);
        submit(beginService(ANA, sender));
        return west.access("91", "0627 07 03331981 05f4" + tmsiOfEva);
    }

    private boolean isSapi3Opened(String channel) {
        return west.received.contains(OctetString.ofHex("020401" + channel + "0203"));
    }
}
