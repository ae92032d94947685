package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import simgsm.abis.RslMessage;
import simgsm.air.ProtocolViolation;
import simgsm.sms.BroadcastSerial;
import simgsm.sms.CellBroadcast;
import simgsm.sms.CellBroadcastPage;

/** Cell broadcast from the exchange to all attached subscribers. */
class BroadcastTest extends MessageStage {
    @Test
    void aBroadcastReachesAttachedSubscribersOnly() throws ProtocolViolation {
        assertEquals(
                1,
                network.exchange
                        .broadcast(0, BroadcastOrder.once(50, "no subscriber is attached yet"))
                        .pages());
        TestMobile one = network.attach("5550100");
        TestMobile other = network.attach("5550200");
        network.attach("5550300").vanish();
        TestMobile stranger = network.connect("5550400");
        stranger.received.clear();
        String text = "a".repeat(100);
        assertEquals(
                2,
                network.exchange
                        .broadcast(network.nowNanos, BroadcastOrder.once(50, text))
                        .pages());
        for (TestMobile mobile : List.of(one, other)) {
            List<CellBroadcastPage> pages = new ArrayList<>();
            for (int i = 0; i < 2; i++) {
                pages.add(CellBroadcastPage.decode(
                        mobile.next(RslMessage.SmsBroadcastCommand.class).page()));
            }
            CellBroadcast message = CellBroadcast.join(pages);
            assertEquals(text, message.text());
            assertEquals(50, message.messageIdentifier());
        }
        assertTrue(stranger.hasNothing());
    }

    @Test
    void twoBroadcastsDifferByTheirSerials() throws ProtocolViolation {
        TestMobile mobile = network.attach("5550100");
        network.exchange.broadcast(network.nowNanos, BroadcastOrder.once(50, "same"));
        network.exchange.broadcast(network.nowNanos, BroadcastOrder.once(50, "same"));
        var first = CellBroadcastPage.decode(
                mobile.next(RslMessage.SmsBroadcastCommand.class).page());
        var second = CellBroadcastPage.decode(
                mobile.next(RslMessage.SmsBroadcastCommand.class).page());
        assertFalse(first.serial().equals(second.serial()));
    }

    private BroadcastView repeat(String text, int periodSeconds, OptionalInt times, OptionalInt updated) {
        return network.exchange.broadcast(
                network.nowNanos,
                new BroadcastOrder(50, text, Optional.of("es"), Duration.ofSeconds(periodSeconds), times, updated));
    }

    private static CellBroadcastPage page(TestMobile mobile) throws ProtocolViolation {
        return CellBroadcastPage.decode(
                mobile.next(RslMessage.SmsBroadcastCommand.class).page());
    }

    @Test
    void aRepeatedBroadcastGoesOutAsOftenAsOrderedAndIsTheSameEachTime() throws ProtocolViolation {
        TestMobile mobile = network.attach("5550100");
        repeat("lluvia", 60, OptionalInt.of(3), OptionalInt.empty());
        CellBroadcastPage first = page(mobile);
        assertEquals(Optional.of("es"), first.coding().language());
        network.passSeconds(59);
        assertTrue(network.exchange.broadcasts().get(0).sent() == 1);
        network.passSeconds(1);
        assertEquals(first, page(mobile));
        assertEquals(1, network.exchange.broadcasts().get(0).left().getAsInt());
        network.passSeconds(60);
        assertEquals(List.of(), network.exchange.broadcasts());
        assertEquals(first, page(mobile));
        network.passSeconds(600);
        assertTrue(mobile.received.stream().noneMatch(RslMessage.SmsBroadcastCommand.class::isInstance));
    }

    @Test
    void whoComesLaterGetsTheNextRepetitionUntilItIsStopped() throws ProtocolViolation {
        BroadcastView begun = repeat("hola", 30, OptionalInt.empty(), OptionalInt.empty());
        TestMobile late = network.attach("5550100");
        network.passSeconds(31);
        assertEquals(50, page(late).messageIdentifier());
        assertTrue(network.exchange.stopBroadcast(begun.id()));
        assertFalse(network.exchange.stopBroadcast(begun.id()));
        network.passSeconds(120);
        assertTrue(late.received.stream().noneMatch(RslMessage.SmsBroadcastCommand.class::isInstance));
    }

    @Test
    void anUpdateKeepsTheMessageCodeAndCountsUp() throws ProtocolViolation {
        TestMobile mobile = network.attach("5550100");
        BroadcastView begun = repeat("12 grados", 60, OptionalInt.empty(), OptionalInt.empty());
        BroadcastView updated = repeat("13 grados", 60, OptionalInt.empty(), OptionalInt.of(begun.id()));
        BroadcastSerial before = page(mobile).serial();
        BroadcastSerial after = page(mobile).serial();
        assertEquals(before.code(), after.code());
        assertEquals(before.update() + 1, after.update());
        assertEquals(List.of(updated), network.exchange.broadcasts());
    }

    @Test
    void whatCannotBeBroadcastIsRefusedAndNamed() {
        String tooLong = "a".repeat(15 * 93 + 1);
        assertRefused("16 pages", () -> repeat(tooLong, 60, OptionalInt.of(1), OptionalInt.empty()));
        assertRefused("0 s", () -> repeat("x", 0, OptionalInt.of(1), OptionalInt.empty()));
        assertRefused("0 times", () -> repeat("x", 60, OptionalInt.of(0), OptionalInt.empty()));
        assertRefused("no broadcast 9", () -> repeat("x", 60, OptionalInt.of(1), OptionalInt.of(9)));
        assertRefused("65536", () -> BroadcastOrder.once(65_536, "x"));
        for (int i = 0; i < Broadcaster.MOST_RUNNING; i++) {
            repeat("x", 60, OptionalInt.empty(), OptionalInt.empty());
        }
        assertRefused("100 broadcasts", () -> repeat("x", 60, OptionalInt.empty(), OptionalInt.empty()));
    }

    private static void assertRefused(String reason, Executable order) {
        String message = assertThrows(IllegalArgumentException.class, order).getMessage();
        assertTrue(message.contains(reason), message);
    }
}
