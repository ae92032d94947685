package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Call forwarding by service codes, and where calls go then (TS 22.082). */
class CallForwardingTest extends ThreePhones {
    CallForwardingTest() {
        super(false);
    }

    @Test
    void aForwardingIsRegisteredAskedForAndErased() {
        assertEquals(List.of("21 active 5550102"), bob.code("**21*5550102#"));
        assertEquals(List.of("21 active 5550102"), bob.code("*#21#"));
        assertEquals(List.of("21 registered 5550102"), bob.code("#21#"));
        assertEquals(List.of("21 active 5550102"), bob.code("*21#"));
        assertEquals(List.of("21 inactive"), bob.code("##21#"));
        assertEquals(List.of("21 inactive"), bob.code("*#21#"));
    }

    @Test
    void aChangeIsAnsweredOnlyWhenItIsStoredAndUndoneIfItCannotBe() {
        assertEquals(List.of("43 active"), bob.code("*43#"));
        disk = Optional.empty();
        assertEquals(List.of(), bob.code("**21*5550102#"));
        disk = Optional.of(true);
        settle();
        assertEquals(List.of("21 active 5550102"), bob.news());

        disk = Optional.of(false);
        assertEquals(List.of("refused 34"), bob.code("##002#"));
        assertEquals(List.of("refused 34"), bob.code("#43#"));
        assertEquals(List.of("21 active 5550102"), bob.code("*#21#"));
        assertEquals(List.of("43 active"), bob.code("*#43#"));
        disk = Optional.of(true);
        assertEquals(List.of("21 inactive"), bob.code("##21#"));
    }

    @Test
    void aPhoneThatGoesAwayBeforeItsChangeIsStoredGetsNoAnswer() {
        disk = Optional.empty();
        bob.code("**21*5550102#");
        bob.station.powerOff();
        settle();
        bob.news();
        disk = Optional.of(true);
        bob.station.powerOn();
        settle();
        assertEquals(List.of(), bob.news());
        assertEquals(List.of("21 active 5550102"), bob.code("*#21#"));
    }

    @ParameterizedTest
    @CsvSource({
        "**21*5550101#, 36, one's own number",
        "**21#, 35, no number",
        "*21#, 17, nothing registered",
        "*#002#, 16, a group",
        "**43#, 16, call waiting takes no number",
        "*#33#, 21, call barring"
    })
    void whatMakesNoSenseIsRefusedWithTheStandardsError(String code, int error, String why) {
        assertEquals(List.of("refused " + error), bob.code(code), why);
    }

    @Test
    void allCallsGoToTheOtherPhone() {
        bob.code("**21*5550102#");
        alice.dial(BOB);
        assertEquals(List.of("ringing 5550100"), carol.news());
        assertEquals(List.of(), bob.news());
        carol.station.answer();
        settle();
        assertEquals(List.of("connected 5550100"), carol.news());
        assertEquals("alerting", alice.news().get(0));
        alice.station.hangUp();
        settle();
        assertEquals(List.of("released 16"), carol.news());
        assertTrue(exchange.calls().isEmpty());
    }

    @Test
    void aCallToABusyPhoneGoesOn() {
        aliceTalksWithBob();
        Phone dave = new Phone("5550103", true);
        bob.code("**67*5550102#");
        dave.dial(BOB);
        assertEquals(List.of("ringing 5550103"), carol.news());
        assertEquals(List.of(), bob.news());
    }

    @Test
    void aCallThatIsNotAnsweredGoesOnAfter20Seconds() {
        bob.code("**61*5550102#");
        alice.dial(BOB);
        assertEquals(List.of("ringing 5550100"), bob.news());
        seconds(19);
        assertEquals(List.of(), carol.news());
        seconds(2);
        assertEquals(List.of("released 16"), bob.news());
        assertEquals(List.of("ringing 5550100"), carol.news());
        carol.station.answer();
        settle();
        assertEquals(List.of("alerting", "connected 5550102"), alice.news());
    }

    /** TS 22.082, 3: 5 to 30 s in steps of 5; the answer tells the time. */
    @ParameterizedTest
    @ValueSource(ints = {5, 25, 30})
    void aCallThatIsNotAnsweredGoesOnAfterTheTimeThatTheSubscriberHasSet(int noReplySeconds) {
        String code = "**61*5550102**" + noReplySeconds + "#";
        assertEquals(List.of("61 active 5550102 after " + noReplySeconds + " s"), bob.code(code));
        assertEquals(List.of("61 active 5550102 after " + noReplySeconds + " s"), bob.code("*#61#"));
        alice.dial(BOB);
        seconds(noReplySeconds - 1);
        assertEquals(List.of("ringing 5550100"), bob.news());
        assertEquals(List.of(), carol.news());
        seconds(2);
        assertEquals(List.of("ringing 5550100"), carol.news());
    }

    /** TS 22.030, annex C; TS 29.002, 17.5: errors 10 and 11; TS 22.082, 3: error 36. */
    @ParameterizedTest
    @CsvSource({
        "*21*5550102*13#, 11", "**21*5550102*16#, 11", "##21**12#, 11", "*21*5550102*20#, 10", "*21*5550102*25#, 10",
        "*43*13#, 11", "**61*5550102**4#, 36", "**61*5550102**7#, 36", "**61*5550102**35#, 36", "**21*5550102**20#, 36"
    })
    void aServiceOrTimeThatTheNetworkDoesNotHaveIsRefusedAndChangesNothing(String code, int error) {
        assertEquals(List.of("refused " + error), bob.code(code));
        assertEquals(List.of("21 inactive"), bob.code("*#21#"));
        alice.dial(BOB);
        assertEquals(List.of("ringing 5550100"), bob.news());
        seconds(25);
        assertEquals(List.of(), carol.news());
    }

    @ParameterizedTest
    @ValueSource(strings = {"**21*5550102*10#", "**21*5550102*11#", "**21*5550102*19#"})
    void aGroupThatIncludesSpeechForwardsCalls(String code) {
        assertEquals(List.of("21 active 5550102"), bob.code(code));
    }

    @Test
    void anInternationalNumberKeepsItsPlusAndIsReachedByItsDigits() {
        assertEquals(List.of("21 active +5550102"), bob.code("**21*+5550102#"));
        alice.dial(BOB);
        assertEquals(List.of("ringing 5550100"), carol.news());
    }

    @Test
    void aCallThatIsAnsweredInTimeStays() {
        bob.code("**61*5550102#");
        alice.dial(BOB);
        bob.station.answer();
        seconds(25);
        assertEquals(List.of(), carol.news());
        assertEquals(List.of("ringing 5550100", "connected 5550100"), bob.news());
    }

    @Test
    void aCallToAPhoneOutOfReachGoesOn() {
        bob.code("**62*5550102#");
        bob.station.powerOff();
        settle();
        alice.dial(BOB);
        assertEquals(List.of("ringing 5550100"), carol.news());
    }

    @Test
    void aHangUpBeforeTheForwardingEndsIt() {
        bob.code("**61*5550102#");
        alice.dial(BOB);
        alice.station.hangUp();
        seconds(25);
        assertEquals(List.of(), carol.news());
        assertTrue(exchange.calls().isEmpty());
    }

    @Test
    void aCircleOfForwardingsEnds() {
        bob.code("**21*5550102#");
        carol.code("**21*5550101#");
        alice.dial(BOB);
        assertEquals(List.of("released 21"), alice.news());
        assertEquals(List.of(), bob.news());
        assertEquals(List.of(), carol.news());
        assertTrue(exchange.calls().isEmpty());
    }

    @Test
    void anUnassignedNumberRefusesTheCall() {
        bob.code("**21*5559999#");
        alice.dial(BOB);
        assertEquals(List.of("released 1"), alice.news());
    }

    @Test
    void allConditionsAreErasedAtOnce() {
        bob.code("**004*5550102#");
        assertEquals(List.of("67 active 5550102"), bob.code("*#67#"));
        assertEquals(List.of("62 active 5550102"), bob.code("*#62#"));
        bob.code("##002#");
        assertEquals(List.of("61 inactive"), bob.code("*#61#"));
    }

    @Test
    void callWaitingIsEachSubscribersChoice() {
        assertEquals(List.of("43 inactive"), bob.code("*#43#"));
        assertEquals(List.of("43 active"), bob.code("*43#"));
        assertEquals(List.of("43 active"), bob.code("*#43#"));
        aliceTalksWithBob();
        carol.dial(BOB);
        assertEquals(List.of("waiting 5550102"), bob.news());
        carol.station.hangUp();
        settle();
        bob.news();
        assertEquals(List.of("43 inactive"), bob.code("#43#"));
        carol.news();
        carol.dial(BOB);
        assertEquals(List.of("released 17"), carol.news());
    }
}
