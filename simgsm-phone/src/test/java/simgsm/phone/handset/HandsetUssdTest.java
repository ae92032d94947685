package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.Screen;
import simgsm.phone.screen.Screen.Ussd.Phase;
import simgsm.phone.screen.Words;
import simgsm.ss.SsError;
import simgsm.station.context.StationEvent;
import simgsm.station.context.UssdEnding;

/** Service codes: keyed with the green key, answered on the display. */
class HandsetUssdTest {
    private final Bench bench = new Bench();

    private void key(String keys) {
        keys.chars().forEach(key -> bench.tap(PhoneKey.ofSymbol((char) key).orElseThrow()));
    }

    private void request() {
        key("*100#");
        bench.tap(PhoneKey.CALL);
    }

    private void answer(String text, boolean replyExpected) {
        bench.handset.accept(new StationEvent.UssdReceived(text, replyExpected));
    }

    private void ended(UssdEnding how, Optional<SsError> error) {
        bench.handset.accept(new StationEvent.UssdEnded(how, error));
    }

    @Test
    void aCodeAndTheGreenKeyAskTheNetworkAndItsTextIsShown() {
        request();
        assertEquals(List.of("ussd *100#"), bench.station.asked);
        assertEquals(
                new Screen.Ussd(Phase.WAITING, "*100#", ""), bench.snapshot().screen());
        assertEquals("", bench.snapshot().typed());

        answer("5550100", false);
        assertEquals(
                new Screen.Ussd(Phase.ANSWERED, "5550100", ""), bench.snapshot().screen());
        bench.tap(PhoneKey.OK);
        assertEquals(new Screen.HomeView(), bench.snapshot().screen());
    }

    @Test
    void theLastKeyOfItsCodeShowsTheImeiWithoutTheNetwork() {
        key("*#06#");
        assertEquals(
                new Screen.Details(Words.plain("IMEI"), List.of(Words.plain("490154203237518"))),
                bench.snapshot().screen());
        assertEquals(List.of(), bench.station.asked);
        assertEquals("", bench.snapshot().typed());
        bench.tap(PhoneKey.SOFT_RIGHT);
        assertEquals(new Screen.HomeView(), bench.snapshot().screen());
    }

    @Test
    void aQuestionIsAnsweredWithTheKeys() {
        request();
        answer("1 or 2?", true);
        key("25");
        bench.tap(PhoneKey.LEFT, PhoneKey.OK);

        assertEquals(List.of("ussd *100#", "ussd 2"), bench.station.asked);
        assertEquals(new Screen.Ussd(Phase.WAITING, "2", ""), bench.snapshot().screen());
    }

    @Test
    void aQuestionIsAnsweredWithAKeyboardToo() {
        answer("Your name?", true);
        "Ada".chars().forEach(letter -> bench.keys().charDown((char) letter, bench.nowNanos));

        assertEquals(
                new Screen.Ussd(Phase.ASKED, "Your name?", "Ada"),
                bench.snapshot().screen());
    }

    @Test
    void okWithoutAReplyWaitsForOne() {
        answer("1 or 2?", true);
        bench.tap(PhoneKey.OK);

        assertEquals(List.of(), bench.station.asked);
        assertEquals(
                new Screen.Ussd(Phase.ASKED, "1 or 2?", ""), bench.snapshot().screen());
    }

    @Test
    void theRedKeyEndsTheDialogue() {
        answer("1 or 2?", true);
        bench.tap(PhoneKey.END);

        assertEquals(List.of("end ussd"), bench.station.asked);
        assertEquals(new Screen.HomeView(), bench.snapshot().screen());
    }

    @Test
    void aRefusalIsANote() {
        request();
        ended(UssdEnding.REFUSED, Optional.of(SsError.UNEXPECTED_DATA_VALUE));
        assertEquals(
                new Screen.Note(Screen.Note.Kind.USSD_UNKNOWN, ""),
                bench.snapshot().screen());

        request();
        ended(UssdEnding.REFUSED, Optional.of(SsError.FACILITY_NOT_SUPPORTED));
        assertEquals(
                new Screen.Note(Screen.Note.Kind.USSD_REFUSED, "21"),
                bench.snapshot().screen());
    }

    @Test
    void aTextThatIsReadStaysWhenTheDialogueEnds() {
        answer("Welcome", false);
        ended(UssdEnding.COMPLETED, Optional.empty());

        assertEquals(
                new Screen.Ussd(Phase.ANSWERED, "Welcome", ""), bench.snapshot().screen());
    }

    @Test
    void aDraftSurvivesATextOfTheNetwork() {
        bench.tap(PhoneKey.MESSAGE, PhoneKey.TWO);
        answer("Welcome", false);
        bench.tap(PhoneKey.OK, PhoneKey.MESSAGE);

        assertEquals("A", ((Screen.Writing) bench.snapshot().screen()).text());
    }

    @Test
    void theEndOfTheProgramWaitsForTheAnswer() {
        request();
        boolean[] settled = new boolean[1];
        bench.handset.whenSettled(() -> settled[0] = true);
        assertEquals(false, settled[0]);

        answer("5550100", false);
        assertTrue(settled[0]);
    }

    @Test
    void aSwitchedOffPhoneAndATooLongTextAreRefused() {
        assertEquals(Optional.of(Refusal.USSD_TOO_LONG), bench.handset.codes().send("1".repeat(183)));
        assertEquals(Optional.of(Refusal.EMPTY_TEXT), bench.handset.codes().send(""));
        bench.handset.powerOff();
        assertEquals(Optional.of(Refusal.SWITCHED_OFF), bench.handset.codes().send("*100#"));
    }
}
