package simgsm.phone;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.phone.handset.Bench;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.RingTone;
import simgsm.phone.store.MessageFolder;
import simgsm.phone.store.StoredMessage;
import simgsm.sim.SimPhoneBook;
import simgsm.station.context.StationEvent;

/** What a phone keeps from run to run. */
class PhoneDataTest {
    private static final Msisdn OWN = new Msisdn("5550100");

    @TempDir
    Path folder;

    private static Bench used() {
        Bench bench = new Bench();
        bench.phoneBook.write(3, new SimPhoneBook.Entry("+5550200", "Robot \u00f1"));
        bench.handset.accept(new StationEvent.ShortMessageReceived("5550200", "3 Done\nand\ttabs = all"));
        bench.handset.sendMessage(new Msisdn("5550200"), "on its way");
        bench.station.ring("5550101");
        bench.station.release(Cause.NORMAL_CALL_CLEARING);
        bench.tap(PhoneKey.MESSAGE);
        bench.type("draft");
        bench.tap(PhoneKey.SOFT_LEFT, PhoneKey.TWO, PhoneKey.END, PhoneKey.MENU);
        bench.key("524");
        return bench;
    }

    private Bench again(Bench before) throws IOException {
        try (PhoneData data = PhoneData.take(folder, OWN)) {
            data.write(before.handset.texts());
        }
        Bench after = new Bench();
        try (PhoneData data = PhoneData.take(folder, OWN)) {
            assertEquals(List.of(), after.handset.restore(data.read()));
        }
        return after;
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aSecondPhoneIsRefusedAlthoughTheLockFileIsDeleted(boolean isWritten) throws IOException {
        try (PhoneData data = PhoneData.take(folder, OWN)) {
            data.read();
            if (isWritten) {
                data.write(used().handset.texts());
            }
            Files.delete(folder.resolve("phone-5550100.lock"));
            try (PhoneData second = PhoneData.take(folder, OWN)) {
                IOException refused = assertThrows(IOException.class, second::read);
                assertTrue(refused.getMessage().startsWith("another phone 5550100 holds"), refused.getMessage());
            }
        }
    }

    @Test
    void namesCallsMessagesAndSettingsAreThereAgain() throws IOException {
        Bench before = used();
        Bench after = again(before);
        assertEquals(before.phoneBook.entries(), after.phoneBook.entries());
        assertEquals(
                "3 Done\nand\ttabs = all",
                after.snapshot().in(MessageFolder.INBOX).get(0).text());
        assertEquals(1, after.snapshot().unread());
        assertEquals("draft", after.snapshot().in(MessageFolder.DRAFTS).get(0).text());
        assertEquals(RingTone.SILENT, after.snapshot().settings().ringTone());
        assertEquals(0, after.snapshot().missed());
        after.tap(PhoneKey.MENU);
        after.key("31");
        assertEquals(1, after.list().rows().size());
        assertEquals(Optional.of(Bench.NOON), after.list().rows().get(0).at());
    }

    @Test
    void whatCouldNotBeWrittenIsWrittenAtTheEnd() throws IOException {
        Path file = folder.resolve("phone-5550100.properties");
        Path obstacle = Files.createDirectories(file.resolve("obstacle"));
        try (PhoneData data = PhoneData.take(folder, OWN)) {
            data.write(Map.of("volume", "3"));
            Files.delete(obstacle);
            Files.delete(file);
        }
        try (PhoneData data = PhoneData.take(folder, OWN)) {
            assertEquals(Map.of("volume", "3"), data.read());
        }
    }

    @Test
    void aMessageThatWasOnItsWayHasFailedAndNoReportOfThisRunIsItsOwn() throws IOException {
        Bench after = again(used());
        assertEquals(
                StoredMessage.Delivery.FAILED,
                after.snapshot().in(MessageFolder.OUTBOX).get(0).delivery());
        after.handset.accept(new StationEvent.MessageDelivered(0, new Msisdn("5550200")));
        assertEquals(
                StoredMessage.Delivery.FAILED,
                after.snapshot().in(MessageFolder.OUTBOX).get(0).delivery());
    }

    @Test
    void whatIsNotUnderstoodIsLeftOutAndNamed() {
        Bench bench = new Bench();
        List<String> wrong = bench.handset.restore(Map.of(
                "name.0", "1\tx",
                "name.a", "1\tx",
                "name.5", "1\tgood",
                "call.0001", "LOST\t1\t1\t1",
                "message.0001", "INBOX",
                "other", "x",
                "setting.volume", "99x"));
        assertEquals(List.of("call.0001", "message.0001", "name.0", "name.a", "setting"), wrong);
        assertEquals(1, bench.phoneBook.entries().size());
    }

    @Test
    void aFileThatIsNoTextIsNamed() throws IOException {
        Files.write(folder.resolve("phone-5550100.properties"), new byte[] {'a', '=', (byte) 0xff, (byte) 0xfe});
        try (PhoneData data = PhoneData.take(folder, OWN)) {
            IOException error = assertThrows(IOException.class, data::read);
            assertTrue(error.getMessage().contains("phone-5550100.properties"), error.getMessage());
        }
    }

    @Test
    void aPhoneThatIsNewHasNothing() throws IOException {
        try (PhoneData data = PhoneData.take(folder.resolve("new"), OWN)) {
            assertEquals(Map.of(), data.read());
        }
    }

    @Test
    void aSecondPhoneOfTheNumberIsRefusedByTheFoldersName() throws IOException {
        try (PhoneData first = PhoneData.take(folder, OWN)) {
            IOException refusal = assertThrows(IOException.class, () -> PhoneData.take(folder, OWN));
            assertEquals(
                    "another phone 5550100 holds the data directory " + folder + "; expected another one by --data DIR",
                    refusal.getMessage());
            assertEquals(Map.of(), first.read());
        }
        PhoneData.take(folder, OWN).close();
    }

    @Test
    void aPhoneOfAnotherNumberMayUseTheSameFolder() throws IOException {
        try (PhoneData first = PhoneData.take(folder, OWN);
                PhoneData second = PhoneData.take(folder, new Msisdn("5550101"))) {
            first.write(Map.of("name.0001", "1\tfirst"));
            second.write(Map.of("name.0001", "1\tsecond"));
            assertEquals(Map.of("name.0001", "1\tfirst"), first.read());
        }
    }

    /** Each change is kept at once, and nothing is written while nothing changes. */
    @Test
    void eachChangeIsKeptBeforeItsEventIsReported() {
        Bench bench = new Bench();
        List<String> course = bench.events;
        bench.handset.keepBy(texts -> course.add("kept " + texts.size()));
        bench.handset.accept(new StationEvent.ShortMessageReceived("5550200", "3 Done"));
        bench.handset.accept(new StationEvent.StationChanged());
        bench.phoneBook.write(1, new SimPhoneBook.Entry("5550200", "Robot"));
        bench.handset.readInbox();
        bench.handset.readInbox();
        bench.key("12");
        assertEquals(List.of("kept 5", "kept 6", "sms 5550200 3 Done", "kept 7", "kept 7"), course);
    }
}
