package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.air.ProtocolViolation;
import simgsm.air.RslMessage;
import simgsm.sms.CellBroadcast;
import simgsm.sms.CellBroadcastPage;

/** Cell broadcast from the exchange to all who are attached. */
class BroadcastTest extends MessageStage {
    @Test
    void aBroadcastReachesAllWhoAreAttachedAndNobodyElse() throws ProtocolViolation {
        assertEquals(1, network.exchange.broadcast(0, 50, "nobody is here yet"));
        TestMobile one = network.attach("5550100");
        TestMobile other = network.attach("5550200");
        network.attach("5550300").vanish();
        TestMobile stranger = network.connect("5550400");
        stranger.received.clear();
        String text = "a".repeat(100);
        assertEquals(2, network.exchange.broadcast(network.nowNanos, 50, text));
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
    void twoBroadcastsAreToldApartByTheirSerials() throws ProtocolViolation {
        TestMobile mobile = network.attach("5550100");
        network.exchange.broadcast(network.nowNanos, 50, "same");
        network.exchange.broadcast(network.nowNanos, 50, "same");
        var first = CellBroadcastPage.decode(
                mobile.next(RslMessage.SmsBroadcastCommand.class).page());
        var second = CellBroadcastPage.decode(
                mobile.next(RslMessage.SmsBroadcastCommand.class).page());
        assertFalse(first.serial().equals(second.serial()));
    }
}
