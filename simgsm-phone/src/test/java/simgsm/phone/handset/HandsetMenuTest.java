package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.phone.screen.KeyMode;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.RingTone;
import simgsm.phone.screen.Screen;
import simgsm.phone.screen.SoftKeys;
import simgsm.phone.store.MessageFolder;
import simgsm.phone.store.StoredMessage;
import simgsm.sim.SimPhoneBook;
import simgsm.speech.SpeechCodec;
import simgsm.station.context.StationEvent;

/** The menu, page by page, by keys. */
class HandsetMenuTest {
    private final Bench bench = new Bench();

    private void menu(String digits) {
        bench.tap(PhoneKey.END, PhoneKey.MENU);
        bench.key(digits);
    }

    private String title() {
        return bench.list().title().key();
    }

    private List<Object> labels() {
        return bench.list().rows().stream()
                .map(row -> row.label().key().isEmpty()
                        ? row.label().arguments().get(0)
                        : row.label().key())
                .toList();
    }

    private Screen.Note.Kind note() {
        return ((Screen.Note) bench.snapshot().screen()).kind();
    }

    private void message(String from, String text) {
        bench.handset.accept(new StationEvent.ShortMessageReceived(from, text));
    }

    @Test
    void theKeysUnderTheDisplayOpenTheMenuAndTheNamesAndGoBack() {
        assertEquals(new SoftKeys("soft.menu", "soft.names"), bench.snapshot().softKeys());
        bench.tap(PhoneKey.SOFT_LEFT);
        assertEquals("key.menu", title());
        bench.tap(PhoneKey.SOFT_LEFT);
        assertEquals("menu.messages", title());
        bench.tap(PhoneKey.SOFT_RIGHT, PhoneKey.SOFT_RIGHT, PhoneKey.SOFT_RIGHT);
        assertEquals("menu.names", title());
    }

    @Test
    void theArrowsGoRoundTheMenu() {
        bench.tap(PhoneKey.MENU, PhoneKey.UP, PhoneKey.UP);
        assertEquals(5, bench.list().selected());
        bench.tap(PhoneKey.DOWN, PhoneKey.DOWN);
        assertEquals(0, bench.list().selected());
    }

    @Test
    void aNameIsWrittenOnTheSimAndShownForItsNumber() {
        bench.tap(PhoneKey.SOFT_RIGHT, PhoneKey.OK);
        bench.type("Robot");
        bench.tap(PhoneKey.OK);
        bench.key("5550200");
        bench.tap(PhoneKey.SOFT_LEFT);
        assertEquals(Screen.Note.Kind.SAVED, note());
        assertEquals(
                new SimPhoneBook.Entry("5550200", "Robot"),
                bench.phoneBook.entries().get(1));
        assertEquals("Robot", bench.snapshot().nameOf("+5550200"));
        bench.tap(PhoneKey.OK);
        assertEquals(List.of("option.new_name", "Robot"), labels());
    }

    @Test
    void aNameIsChangedCalledAndErased() {
        bench.phoneBook.write(7, new SimPhoneBook.Entry("5550200", "Robt"));
        bench.tap(PhoneKey.SOFT_RIGHT, PhoneKey.OK);
        bench.key("3");
        bench.tap(PhoneKey.LEFT);
        bench.type("o");
        bench.tap(PhoneKey.OK, PhoneKey.OK, PhoneKey.OK);
        assertEquals("Robot", bench.phoneBook.entries().get(7).name());
        bench.tap(PhoneKey.CALL);
        assertEquals(List.of("dial 5550200"), bench.station.asked);
        bench.handset.hangUp();
        bench.tap(PhoneKey.END, PhoneKey.SOFT_RIGHT, PhoneKey.OK);
        bench.key("4");
        bench.tap(PhoneKey.SOFT_LEFT);
        assertTrue(bench.phoneBook.entries().isEmpty());
    }

    @Test
    void aFullSimTakesNoFurtherName() {
        for (int place = 1; place <= SimPhoneBook.CAPACITY; place++) {
            bench.phoneBook.write(place, new SimPhoneBook.Entry("1", "n"));
        }
        bench.tap(PhoneKey.SOFT_RIGHT, PhoneKey.UP, PhoneKey.OK);
        assertEquals(Screen.Note.Kind.SIM_FULL, note());
    }

    @Test
    void aNumberBeingKeyedIsSavedUnderAName() {
        bench.key("5550200");
        bench.tap(PhoneKey.SOFT_LEFT);
        bench.type("R");
        bench.tap(PhoneKey.OK, PhoneKey.OK);
        assertEquals("5550200", bench.phoneBook.entries().get(1).number());
    }

    @Test
    void aReceiverIsChosenAmongTheNames() {
        bench.phoneBook.write(1, new SimPhoneBook.Entry("5550200", "Robot"));
        bench.tap(PhoneKey.MESSAGE);
        bench.type("** #*0 **");
        bench.tap(PhoneKey.OK, PhoneKey.DOWN, PhoneKey.OK, PhoneKey.SOFT_LEFT);
        assertEquals(List.of("sms 5550200 ** #*0 **"), bench.station.asked);
    }

    @Test
    void callsAreLoggedByTheirKind() {
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550200"))));
        bench.speechMillis(3_000);
        bench.handset.hangUp();
        bench.station.ring("5550101");
        bench.station.release(Cause.NORMAL_CALL_CLEARING);
        bench.station.ring("5550102");
        bench.tap(PhoneKey.END);
        assertEquals(1, bench.snapshot().missed());
        menu("31");
        assertEquals(List.of("5550101"), labels());
        assertEquals(0, bench.snapshot().missed());
        menu("32");
        assertEquals(List.of("5550102"), labels());
        menu("33");
        assertEquals(List.of("5550200"), labels());
        bench.tap(PhoneKey.OK);
        Screen.Details details = (Screen.Details) bench.snapshot().screen();
        assertEquals(List.of("00:03"), details.lines().get(2).arguments());
        menu("34");
        bench.tap(PhoneKey.SOFT_LEFT);
        menu("33");
        assertEquals(List.of(), labels());
    }

    @Test
    void aWaitingCallThatEndsIsAMissedCall() {
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.Connected(Optional.empty()));
        bench.handset.accept(new StationEvent.CallWaits(Optional.of(new Msisdn("5550101"))));
        bench.handset.accept(new StationEvent.WaitingCallEnded());
        assertEquals(1, bench.snapshot().missed());
    }

    @Test
    void aMessageIsForwarded() {
        message("5550200", "3 Done");
        bench.tap(PhoneKey.SOFT_LEFT, PhoneKey.SOFT_LEFT);
        bench.key("2");
        assertEquals("3 Done", ((Screen.Writing) bench.snapshot().screen()).text());
        bench.tap(PhoneKey.OK);
        bench.key("5550101");
        bench.tap(PhoneKey.OK);
        assertEquals(List.of("sms 5550101 3 Done"), bench.station.asked);
    }

    @Test
    void aTextIsKeptAsADraftAndSentLater() {
        bench.tap(PhoneKey.MESSAGE);
        bench.type("later");
        bench.tap(PhoneKey.SOFT_LEFT);
        bench.key("2");
        assertEquals(Screen.Note.Kind.SAVED, note());
        assertEquals(
                List.of("later"),
                bench.snapshot().in(MessageFolder.DRAFTS).stream()
                        .map(StoredMessage::text)
                        .toList());
        menu("14");
        bench.tap(PhoneKey.OK, PhoneKey.OK);
        bench.key("5");
        bench.tap(PhoneKey.OK);
        assertEquals(List.of("sms 5 later"), bench.station.asked);
        assertEquals(List.of(), bench.snapshot().in(MessageFolder.DRAFTS));
    }

    @Test
    void aReplyMovesTheTextBegunBeforeToTheDrafts() {
        bench.tap(PhoneKey.MESSAGE);
        bench.type("begun");
        bench.tap(PhoneKey.END);
        message("5550200", "3 Done");
        bench.tap(PhoneKey.DOWN, PhoneKey.OK, PhoneKey.OK);
        assertEquals("", ((Screen.Writing) bench.snapshot().screen()).text());
        assertEquals("begun", bench.snapshot().in(MessageFolder.DRAFTS).get(0).text());
    }

    @Test
    void allMessagesAreErasedAfterAQuestionOnly() {
        message("1", "a");
        message("2", "b");
        bench.tap(PhoneKey.DOWN, PhoneKey.SOFT_LEFT);
        bench.key("6");
        bench.tap(PhoneKey.SOFT_RIGHT);
        assertEquals(2, bench.snapshot().in(MessageFolder.INBOX).size());
        bench.tap(PhoneKey.SOFT_LEFT);
        bench.key("6");
        bench.tap(PhoneKey.SOFT_LEFT);
        assertEquals(0, bench.snapshot().in(MessageFolder.INBOX).size());
    }

    @Test
    void theLettersOfATextAreChangedAtItsCursor() {
        bench.tap(PhoneKey.MESSAGE);
        bench.type("Hla");
        bench.tap(PhoneKey.LEFT, PhoneKey.LEFT);
        bench.type("o");
        Screen.Writing text = (Screen.Writing) bench.snapshot().screen();
        assertEquals("Hola", text.text());
        assertEquals(2, text.caret());
        bench.tap(PhoneKey.CLEAR);
        assertEquals("Hla", ((Screen.Writing) bench.snapshot().screen()).text());
    }

    @Test
    void aRingIsSilencedAndThenRefused() {
        bench.station.ring("5550101");
        assertEquals(
                new SoftKeys("soft.answer", "soft.silence"), bench.snapshot().softKeys());
        bench.tap(PhoneKey.SOFT_RIGHT);
        bench.millis(400);
        assertFalse(bench.handset.wantsTime());
        assertEquals(
                new SoftKeys("soft.answer", "soft.refuse"), bench.snapshot().softKeys());
        bench.tap(PhoneKey.SOFT_RIGHT);
        assertEquals(List.of("hangUp"), bench.station.asked);
    }

    @Test
    void aSilentPhoneRingsWithoutSound() {
        menu("524");
        assertEquals(RingTone.SILENT, bench.snapshot().settings().ringTone());
        bench.station.ring("5550101");
        bench.millis(400);
        assertFalse(bench.handset.wantsTime());
    }

    @Test
    void settingsAreChosenInTheirMenus() {
        menu("512");
        assertEquals("es", bench.snapshot().settings().language());
        menu("534");
        assertEquals(3, bench.snapshot().settings().volume());
        menu("552");
        assertEquals(SpeechCodec.Kind.GSM_FULL_RATE, bench.snapshot().settings().codec());
        assertEquals("codec GSM_FULL_RATE", bench.station.asked.get(bench.station.asked.size() - 1));
        menu("562");
        assertEquals(KeyMode.SIGNALLED, bench.snapshot().settings().keyMode());
    }

    @Test
    void keysAreSignalledFromTheNextCallOn() {
        menu("562");
        bench.tap(PhoneKey.END);
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.Connected(Optional.empty()));
        bench.tap(PhoneKey.FIVE);
        assertTrue(bench.station.asked.contains("hold 5"), bench.station.asked.toString());
    }

    @Test
    void aShortKeySoundsForItsSetTimeHoweverLongItIsHeld() {
        menu("572");
        bench.tap(PhoneKey.END);
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.Connected(Optional.empty()));
        bench.down(PhoneKey.FIVE);
        bench.speechMillis(600);
        bench.up(PhoneKey.FIVE);
        bench.speechMillis(100);
        assertEquals("5", bench.heardByFarEnd());
        assertEquals(100, bench.tonesMillis().get(0), 15);
    }

    @Test
    void theArrowsSetTheVolumeInACall() {
        bench.station.ring("5550101");
        bench.tap(PhoneKey.CALL, PhoneKey.DOWN, PhoneKey.DOWN, PhoneKey.UP);
        assertEquals(6, bench.snapshot().settings().volume());
    }

    @Test
    void forwardingIsSentAsItsCode() {
        menu("4311");
        bench.key("5550101");
        bench.tap(PhoneKey.SOFT_LEFT);
        menu("4342");
        menu("435");
        menu("441");
        assertEquals(
                List.of("ussd **21*5550101#", "ussd *#62#", "ussd ##002#", "ussd *43#"),
                bench.station.asked.stream()
                        .filter(asked -> asked.startsWith("ussd"))
                        .toList());
    }

    @Test
    void everyKeyOnEveryPageOfTheMenuDoesNoHarm() {
        for (PhoneKey key : PhoneKey.values()) {
            for (String digits : new String[] {"", "1", "2", "3", "4", "5", "6", "12", "13", "31", "43", "431", "51"}) {
                menu(digits);
                bench.tap(key, key);
            }
            bench.handset.powerOn();
        }
        bench.tap(PhoneKey.END);
        assertEquals(new Screen.HomeView(), bench.snapshot().screen());
    }
}
