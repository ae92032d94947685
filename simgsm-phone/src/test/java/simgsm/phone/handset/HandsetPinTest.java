package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.Screen;
import simgsm.phone.screen.Screen.Note;
import simgsm.phone.screen.SoftKeys;
import simgsm.phone.screen.Words;
import simgsm.sim.CardPin;
import simgsm.sim.PinLock;
import simgsm.station.context.StationEvent;

/** The questions of a SIM on the display. */
class HandsetPinTest {
    private static final Screen HOME = new Screen.HomeView();

    private final Bench bench = new Bench();

    @BeforeEach
    void aCardWithAPin() {
        insert(new CardPin("1234", "12345678", true, 3, 10));
    }

    private void insert(CardPin pin) {
        bench.station.card = new PinLock(Optional.of(pin), kept -> {});
        bench.handset.powerOn();
    }

    private void key(String symbols) {
        symbols.chars()
                .forEach(symbol -> bench.tap(PhoneKey.ofSymbol((char) symbol).orElseThrow()));
    }

    private Screen screen() {
        return bench.snapshot().screen();
    }

    private static Screen entry(Words title, String text) {
        return new Screen.Entry(title, text, text.length(), "", Optional.empty());
    }

    @Test
    void thePinIsAskedForAtPowerOnAndShownAsStars() {
        assertEquals(entry(Words.of("pin.enter", 3), ""), screen());
        key("1234");
        assertEquals(entry(Words.of("pin.enter", 3), "****"), screen());
        bench.tap(PhoneKey.OK);
        assertEquals(new Note(Note.Kind.SAVED, ""), screen());
        bench.tap(PhoneKey.OK);
        assertEquals(HOME, screen());
    }

    @Test
    void aWrongPinNamesTheTriesThatAreLeft() {
        key("12");
        bench.tap(PhoneKey.OK);
        assertEquals(new Note(Note.Kind.PIN_LENGTH, ""), screen());
        bench.tap(PhoneKey.OK);
        key("34");
        key("5");
        bench.tap(PhoneKey.OK);
        assertEquals(new Note(Note.Kind.PIN_WRONG, "2"), screen());
        bench.tap(PhoneKey.OK);
        assertEquals(entry(Words.of("pin.enter", 2), ""), screen());
    }

    @Test
    void theThirdWrongPinTellsThatThePukIsDue() {
        for (int i = 0; i < 3; i++) {
            key("9999");
            bench.tap(PhoneKey.OK);
        }
        assertEquals(new Note(Note.Kind.PIN_BLOCKED, "10"), screen());
        key("1");
        assertEquals(entry(Words.of("pin.puk", 10), "*"), screen());
    }

    @Test
    void thePukIsAskedForWithTwiceTheSameNewPin() {
        insert(new CardPin("1234", "12345678", true, 0, 10));
        key("12345678");
        bench.tap(PhoneKey.OK);
        key("4321");
        bench.tap(PhoneKey.OK);
        key("4322");
        bench.tap(PhoneKey.OK);
        assertEquals(new Note(Note.Kind.PIN_DIFFERS, ""), screen());
        bench.tap(PhoneKey.OK);
        bench.tap(PhoneKey.CLEAR);
        key("1");
        bench.tap(PhoneKey.OK);
        assertEquals(new Note(Note.Kind.SAVED, ""), screen());
        assertEquals(PinLock.State.READY, bench.station.card.status().state());
    }

    @Test
    void noKeyLeavesTheQuestion() {
        for (PhoneKey key : List.of(PhoneKey.END, PhoneKey.SOFT_RIGHT, PhoneKey.CLEAR, PhoneKey.MENU, PhoneKey.OK)) {
            bench.tap(key);
            assertEquals(entry(Words.of("pin.enter", 3), ""), screen(), key.name());
        }
        bench.keys().eraseDown();
        assertEquals(new SoftKeys("", ""), bench.snapshot().softKeys());
        key("11");
        bench.tap(PhoneKey.END);
        assertEquals(entry(Words.of("pin.enter", 3), ""), screen());
    }

    @Test
    void afterAnEmergencyCallTheNextKeysBelongToThePin() {
        key("112");
        bench.tap(PhoneKey.CALL);
        assertEquals(List.of("dial 112"), bench.station.asked);
        assertEquals(HOME, screen());
        bench.station.release(Cause.NORMAL_CALL_CLEARING);
        assertEquals(HOME, screen());
        bench.type("1234");
        assertEquals(entry(Words.of("pin.enter", 3), "****"), screen());
        bench.keys().enterDown(bench.nowNanos);
        assertEquals(new Note(Note.Kind.SAVED, ""), screen());
    }

    @Test
    void anotherNumberIsRefusedAndCostsNoTry() {
        key("5550200");
        bench.tap(PhoneKey.CALL);
        assertEquals(new Note(Note.Kind.SIM_LOCKED, "5550200"), screen());
        bench.tap(PhoneKey.OK);
        assertEquals(entry(Words.of("pin.enter", 3), "*******"), screen());
        assertEquals(3, bench.station.card.status().tries());
        assertEquals(List.of(), bench.station.asked);
    }

    @Test
    void commandsAreRefusedUntilTheCardHasItsPin() {
        Optional<Refusal> locked = Optional.of(Refusal.SIM_LOCKED);
        assertEquals(locked, bench.handset.dial(new Msisdn("5550200")));
        assertEquals(locked, bench.handset.sendMessage(new Msisdn("5550200"), "hello"));
        assertEquals(locked, bench.handset.codes().send("*100#"));
        assertEquals(List.of(), bench.station.asked);
        bench.station.card.verify("1234");
        assertEquals(Optional.empty(), bench.handset.dial(new Msisdn("5550200")));
    }

    @Test
    void aBlockedCardPermitsEmergencyCalls() {
        insert(new CardPin("1234", "12345678", true, 0, 0));
        bench.type("5550200");
        bench.tap(PhoneKey.CALL);
        assertEquals(new Note(Note.Kind.SIM_LOCKED, "5550200"), screen());
        bench.tap(PhoneKey.OK, PhoneKey.END);
        bench.type("911");
        bench.tap(PhoneKey.CALL);
        assertEquals(List.of("dial 911"), bench.station.asked);
    }

    @Test
    void theQuestionTakesTheCodesOfEquipmentAndCard() {
        bench.type("*#06#");
        assertEquals(Words.plain("IMEI"), ((Screen.Details) screen()).title());
        bench.tap(PhoneKey.OK);
        key("#1*2");
        assertEquals(entry(Words.of("pin.enter", 3), "**"), screen());
        bench.tap(PhoneKey.END);
        key("**04*1234");
        assertEquals(entry(Words.of("pin.enter", 3), "**04*1234"), screen());
        key("*4321*4321#");
        assertEquals(new Note(Note.Kind.SAVED, ""), screen());
        assertEquals(PinLock.Result.DONE, bench.station.card.verify("4321"));
    }

    @Test
    void aCodeForTheCardIsPerformedWithItsLastKey() {
        bench.station.card.verify("1234");
        bench.handset.accept(new StationEvent.SimStateChanged(PinLock.State.READY, 3));
        assertEquals(HOME, screen());
        key("**04*1234*4321*4321#");
        assertEquals(new Note(Note.Kind.SAVED, ""), screen());
        assertEquals(PinLock.Result.DONE, bench.station.card.verify("4321"));
        assertEquals(List.of(), bench.station.asked);
    }
}
