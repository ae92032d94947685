package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.CallPhase;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.Screen;
import simgsm.station.context.StationEvent;

/** Calls, by console and by keys, and the tones that come back. */
class HandsetCallTest {
    private static final Msisdn ROBOT = new Msisdn("5550200");

    @Test
    void aCallIsReportedStepByStep() {
        Bench bench = new Bench();
        bench.handset.dial(ROBOT);
        bench.handset.accept(new StationEvent.CalledPartyAlerted());
        bench.handset.accept(new StationEvent.Connected(Optional.of(ROBOT)));
        bench.handset.hangUp();
        assertEquals(List.of("calling 5550200", "alerting", "connected 5550200", "released 16"), bench.events);
    }

    @Test
    void diallingDuringACallIsRefusedAndTheCallGoesOn() {
        Bench bench = Bench.connected();
        assertEquals(Optional.of(Refusal.CALL_UNDER_WAY), bench.handset.dial(ROBOT));
        assertEquals(CallPhase.CONNECTED, bench.snapshot().call().phase());
    }

    @Test
    void diallingWhileSwitchedOffIsRefused() {
        Bench bench = new Bench();
        bench.handset.powerOff();
        assertEquals(Optional.of(Refusal.SWITCHED_OFF), bench.handset.dial(ROBOT));
    }

    @Test
    void answeringWhenNothingRingsIsRefused() {
        assertEquals(Optional.of(Refusal.NOTHING_RINGS), new Bench().handset.answer());
    }

    @Test
    void hangingUpWithoutACallIsRefused() {
        assertEquals(Optional.of(Refusal.NO_CALL), new Bench().handset.hangUp());
    }

    @ParameterizedTest
    @ValueSource(chars = {'1', '2', '3', '4', '5', '6', '7', '8', '9', '0', '*', '#'})
    void aToneFromTheFarEndIsHeardOnce(char key) {
        Bench bench = Bench.connected();
        bench.farEndPlays(key);
        assertEquals(List.of("tone " + key), bench.events);
        assertEquals(Optional.of(DtmfKey.of(key)), bench.snapshot().call().tone());
    }

    @Test
    void noToneIsHeardBeforeTheCallIsConnected() {
        Bench bench = new Bench();
        bench.handset.dial(ROBOT);
        bench.farEndPlays('1');
        assertEquals(List.of("calling 5550200"), bench.events);
        bench.handset.accept(new StationEvent.Connected(Optional.empty()));
        assertEquals(Optional.empty(), bench.snapshot().call().tone());
    }

    @Test
    void oneSoundCutByTheConnectionIsNotHeardAsAKeyOfTheNextCall() {
        Bench bench = Bench.connected();
        bench.farEndPlays('3');
        bench.station.release(Cause.NORMAL_CALL_CLEARING);
        bench.handset.dial(ROBOT);
        bench.handset.accept(new StationEvent.Connected(Optional.empty()));
        assertEquals(Optional.empty(), bench.snapshot().call().tone());
    }

    @Test
    void theCallsTimeIsCountedInSpeech() {
        Bench bench = Bench.connected();
        bench.speechMillis(61_000);
        assertEquals(61, bench.snapshot().call().seconds());
    }

    @Test
    void aNumberKeyedAndTheGreenKeyMakeACall() {
        Bench bench = new Bench();
        bench.tap(PhoneKey.FIVE, PhoneKey.FIVE, PhoneKey.FIVE, PhoneKey.ZERO, PhoneKey.TWO, PhoneKey.CALL);
        assertEquals(List.of("calling 55502"), bench.events);
    }

    @Test
    void theKeyCErasesTheLastDigitAndTheRedKeyAll() {
        Bench bench = new Bench();
        bench.tap(PhoneKey.FIVE, PhoneKey.SIX, PhoneKey.CLEAR);
        assertEquals("5", bench.snapshot().typed());
        bench.tap(PhoneKey.END);
        assertEquals("", bench.snapshot().typed());
    }

    @Test
    void aNumberIsEditedAtItsCursor() {
        Bench bench = new Bench();
        bench.tap(PhoneKey.FIVE, PhoneKey.SEVEN, PhoneKey.LEFT, PhoneKey.SIX);
        assertEquals("567", bench.snapshot().typed());
        assertEquals(2, bench.snapshot().caret());
        bench.tap(PhoneKey.LEFT, PhoneKey.SOFT_RIGHT, PhoneKey.RIGHT, PhoneKey.RIGHT, PhoneKey.RIGHT, PhoneKey.EIGHT);
        assertEquals("678", bench.snapshot().typed());
        bench.keys().eraseDown();
        assertEquals("67", bench.snapshot().typed());
    }

    @Test
    void theGreenKeyTwiceDialsTheLastNumberAgain() {
        Bench bench = Bench.connected();
        bench.handset.hangUp();
        bench.tap(PhoneKey.CALL);
        assertEquals("calls.dialled", bench.list().title().key());
        bench.tap(PhoneKey.CALL);
        assertEquals(List.of("dial 5550200", "hangUp", "dial 5550200"), bench.station.asked);
    }

    @Test
    void aStarIsNoTelephoneNumberAndNothingIsDialled() {
        Bench bench = new Bench();
        bench.tap(PhoneKey.STAR, PhoneKey.ONE, PhoneKey.CALL);
        assertEquals(
                new Screen.Note(Screen.Note.Kind.NOT_A_NUMBER, "*1"),
                bench.snapshot().screen());
        assertEquals(List.of(), bench.station.asked);
    }

    @Test
    void theGreenKeyAnswersAndTheRedKeyEnds() {
        Bench bench = new Bench();
        bench.station.ring("5550101");
        bench.tap(PhoneKey.CALL);
        assertEquals(CallPhase.CONNECTED, bench.snapshot().call().phase());
        bench.tap(PhoneKey.END);
        assertEquals(
                Optional.of(Cause.NORMAL_CALL_CLEARING), bench.snapshot().call().ended());
    }

    @Test
    void aCallThatRingsComesToTheFrontAndADraftIsKept() {
        Bench bench = new Bench();
        bench.tap(PhoneKey.MESSAGE);
        bench.keys().charDown('h', bench.nowNanos);
        bench.station.ring("5550101");
        assertEquals(new Screen.HomeView(), bench.snapshot().screen());
        bench.tap(PhoneKey.END, PhoneKey.MESSAGE);
        assertEquals("h", ((Screen.Writing) bench.snapshot().screen()).text());
    }

    @Test
    void holdingOneOpensTheMailbox() {
        Bench bench = new Bench();
        bench.down(PhoneKey.ONE);
        bench.millis(1000);
        assertEquals("menu.inbox", bench.list().title().key());
        assertEquals("", bench.snapshot().typed());
    }

    @Test
    void holdingZeroGivesAPlusSign() {
        Bench bench = new Bench();
        bench.down(PhoneKey.ZERO);
        bench.millis(1000);
        bench.up(PhoneKey.ZERO);
        bench.tap(PhoneKey.SEVEN);
        assertEquals("+7", bench.snapshot().typed());
    }

    @Test
    void aKeyHeldWithoutACallSoundsAtTheEarAndThenTimeIsWantedNoMore() {
        Bench bench = new Bench();
        bench.down(PhoneKey.NINE);
        bench.millis(100);
        assertEquals(Optional.of(DtmfKey.NINE), bench.snapshot().sounding());
        bench.up(PhoneKey.NINE);
        bench.millis(1000);
        assertEquals(Optional.empty(), bench.snapshot().sounding());
        assertEquals(false, bench.handset.wantsTime());
    }

    @Test
    void theRedKeySwitchesAPhoneOnThatIsOff() {
        Bench bench = new Bench();
        bench.tap(PhoneKey.MENU, PhoneKey.SEVEN);
        assertEquals(false, bench.snapshot().station().powered());
        bench.tap(PhoneKey.FIVE);
        assertEquals("", bench.snapshot().typed());
        bench.tap(PhoneKey.END);
        assertEquals(true, bench.snapshot().station().powered());
    }

    private static Bench twoCalls() {
        Bench bench = Bench.connected();
        bench.speechMillis(5_000);
        bench.handset.accept(new StationEvent.CallWaits(Optional.of(new Msisdn("5550101"))));
        bench.handset.accept(new StationEvent.CallHeld(Optional.of(ROBOT)));
        bench.handset.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550101"))));
        return bench;
    }

    @Test
    void theRightKeyHoldsACallAndTakesTheWaitingOne() {
        Bench bench = Bench.connected();
        assertEquals("soft.hold", bench.snapshot().softKeys().right());
        bench.handset.accept(new StationEvent.CallWaits(Optional.of(new Msisdn("5550101"))));
        assertEquals("soft.take", bench.snapshot().softKeys().right());
        bench.tap(PhoneKey.SOFT_RIGHT, PhoneKey.CALL);
        bench.tap(PhoneKey.SOFT_LEFT, PhoneKey.TWO);
        assertEquals(List.of("dial 5550200", "hold", "hold", "reject"), bench.station.asked);
    }

    @Test
    void theHeldPartyIsShownBesideTheCallAndEachCallKeepsItsTime() {
        Bench bench = twoCalls();
        bench.speechMillis(2_000);
        assertEquals(Optional.of("5550200"), bench.snapshot().call().held());
        assertEquals("5550101", bench.snapshot().call().number());
        assertEquals("soft.swap", bench.snapshot().softKeys().right());
        bench.handset.accept(new StationEvent.CallHeld(Optional.of(new Msisdn("5550101"))));
        bench.handset.accept(new StationEvent.CallRetrieved(Optional.of(ROBOT)));
        assertEquals("5550200", bench.snapshot().call().number());
        assertEquals(5, bench.snapshot().call().seconds());
        assertEquals(Optional.of("5550101"), bench.snapshot().call().held());
        bench.station.release(Cause.NORMAL_CALL_CLEARING);
        assertEquals("soft.retrieve", bench.snapshot().softKeys().left());
        bench.handset.accept(new StationEvent.CallRetrieved(Optional.of(new Msisdn("5550101"))));
        assertEquals(2, bench.snapshot().call().seconds());
        assertEquals(Optional.empty(), bench.snapshot().call().held());
    }

    @Test
    void aCallThatIsBackHasItsKeysAndTones() {
        Bench bench = Bench.connected();
        bench.handset.press(DtmfKey.sequence("**5"));
        bench.speechMillis(1_000);
        bench.farEndPlays('7');
        bench.handset.accept(new StationEvent.CallWaits(Optional.of(new Msisdn("5550101"))));
        bench.handset.accept(new StationEvent.CallHeld(Optional.of(ROBOT)));
        bench.handset.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550101"))));
        assertEquals("", bench.snapshot().call().keyed());
        bench.handset.press(DtmfKey.sequence("1"));
        bench.speechMillis(1_000);
        bench.handset.accept(new StationEvent.CallHeld(Optional.of(new Msisdn("5550101"))));
        bench.handset.accept(new StationEvent.CallRetrieved(Optional.of(ROBOT)));
        assertEquals("**5", bench.snapshot().call().keyed());
        assertEquals("7", bench.snapshot().call().heard());
        assertEquals(Optional.empty(), bench.snapshot().call().waiting());
        bench.handset.accept(new StationEvent.CallHeld(Optional.of(ROBOT)));
        bench.handset.accept(new StationEvent.CallRetrieved(Optional.of(new Msisdn("5550101"))));
        assertEquals("1", bench.snapshot().call().keyed());
    }

    @Test
    void bothCallsComeToTheLogWithTheirTimes() {
        Bench bench = twoCalls();
        bench.speechMillis(2_000);
        bench.handset.accept(new StationEvent.HeldCallEnded(Cause.NORMAL_CALL_CLEARING));
        bench.station.release(Cause.NORMAL_CALL_CLEARING);
        bench.tap(PhoneKey.END, PhoneKey.MENU, PhoneKey.THREE, PhoneKey.THREE, PhoneKey.OK);
        assertEquals(
                List.of("00:05"),
                ((Screen.Details) bench.snapshot().screen()).lines().get(2).arguments());
        bench.tap(PhoneKey.END, PhoneKey.MENU, PhoneKey.THREE, PhoneKey.TWO, PhoneKey.OK);
        assertEquals(
                List.of("00:02"),
                ((Screen.Details) bench.snapshot().screen()).lines().get(2).arguments());
    }

    @Test
    void aCallThatTheNetworkDoesNotHoldIsANoteAndGoesOn() {
        Bench bench = Bench.connected();
        bench.tap(PhoneKey.SOFT_RIGHT);
        bench.handset.accept(new StationEvent.HoldRefused());
        assertEquals(
                new Screen.Note(Screen.Note.Kind.REFUSED, ""), bench.snapshot().screen());
        bench.tap(PhoneKey.OK);
        assertEquals(CallPhase.CONNECTED, bench.snapshot().call().phase());
    }

    @Test
    void theRedKeyEndsACallThatIsHeldAlone() {
        Bench bench = Bench.connected();
        bench.handset.accept(new StationEvent.CallHeld(Optional.of(ROBOT)));
        bench.tap(PhoneKey.END);
        assertEquals(List.of("dial 5550200", "hangUp"), bench.station.asked);
    }

    /** The first red key only takes the message away: the call that is held goes on. */
    @Test
    void theEndOfTheCallBesideAHeldOneIsReadBeforeTheRedKeyEndsTheHeldOne() {
        Bench bench = Bench.connected();
        Optional<Msisdn> robot = Optional.of(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.CallHeld(robot));
        bench.handset.accept(new StationEvent.Calling(new Msisdn("5559999")));
        bench.handset.accept(new StationEvent.Released(Cause.UNASSIGNED_NUMBER));
        assertEquals(
                Optional.of(Cause.UNASSIGNED_NUMBER), bench.snapshot().call().ended());
        bench.station.asked.clear();
        bench.tap(PhoneKey.END);
        assertEquals(Optional.empty(), bench.snapshot().call().ended());
        assertEquals(List.of(), bench.station.asked);
        bench.tap(PhoneKey.END);
        assertEquals(List.of("hangUp"), bench.station.asked);
    }

    /** No robot calls: the keys of a caller are a person's. */
    @Test
    void aCallersKeysHaveNoMeaning() {
        Bench bench = Bench.connected();
        assertEquals(Optional.of("tone.5"), bench.snapshot().call().meaningOf(DtmfKey.FIVE));
        bench.handset.accept(new StationEvent.CallHeld(Optional.of(new Msisdn("5550200"))));
        bench.station.ring("5550101");
        bench.tap(PhoneKey.CALL);
        assertEquals(Optional.empty(), bench.snapshot().call().meaningOf(DtmfKey.FIVE));
        bench.farEndPlays('5');
        assertEquals(
                "log.tone.plain",
                bench.snapshot()
                        .log()
                        .get(bench.snapshot().log().size() - 1)
                        .words()
                        .key());
        bench.handset.accept(new StationEvent.CallHeld(Optional.of(new Msisdn("5550101"))));
        bench.handset.accept(new StationEvent.CallRetrieved(Optional.of(new Msisdn("5550200"))));
        assertEquals(Optional.of("tone.5"), bench.snapshot().call().meaningOf(DtmfKey.FIVE));
    }
}
