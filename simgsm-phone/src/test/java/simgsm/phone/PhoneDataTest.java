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
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.phone.handset.Bench;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.RingTone;
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
        PhoneData data = new PhoneData(folder, OWN);
        data.write(before.handset.texts());
        Bench after = new Bench();
        assertEquals(List.of(), after.handset.restore(new PhoneData(folder, OWN).read()));
        return after;
    }

    @Test
    void namesCallsMessagesAndSettingsAreThereAgain() throws IOException {
        Bench before = used();
        Bench after = again(before);
        assertEquals(before.phoneBook.entries(), after.phoneBook.entries());
        assertEquals("3 Done\nand\ttabs = all", after.snapshot().inbox().get(0).text());
        assertEquals(1, after.snapshot().unread());
        assertEquals("draft", after.snapshot().drafts().get(0).text());
        assertEquals(RingTone.SILENT, after.snapshot().settings().ringTone());
        assertEquals(0, after.snapshot().missed());
        after.tap(PhoneKey.MENU);
        after.key("31");
        assertEquals(1, after.list().rows().size());
        assertEquals(Optional.of(Bench.NOON), after.list().rows().get(0).at());
    }

    @Test
    void aMessageThatWasOnItsWayHasFailedAndNoReportOfThisRunIsItsOwn() throws IOException {
        Bench after = again(used());
        assertEquals(
                StoredMessage.Delivery.FAILED, after.snapshot().outbox().get(0).delivery());
        after.handset.accept(new StationEvent.MessageDelivered(0, new Msisdn("5550200")));
        assertEquals(
                StoredMessage.Delivery.FAILED, after.snapshot().outbox().get(0).delivery());
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
        IOException error = assertThrows(IOException.class, () -> new PhoneData(folder, OWN).read());
        assertTrue(error.getMessage().contains("phone-5550100.properties"), error.getMessage());
    }

    @Test
    void aPhoneThatIsNewHasNothing() throws IOException {
        assertEquals(Map.of(), new PhoneData(folder.resolve("new"), OWN).read());
    }
}
