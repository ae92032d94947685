package simgsm.center.bsc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslType;
import simgsm.air.Msisdn;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.msc.ExchangeEvent;

/** Mobiles that move between towers and location areas. */
class TowerMobilityTest {
    private static final Msisdn NUMBER = new Msisdn("5550100");

    private final TowerStage stage = new TowerStage();
    private final TestTower west = stage.west();
    private final TestTower east = stage.tower("east arfcn=110 bsic=11 lac=2 cell=6970 tch=7", "6970/0/0");

    /** Location updating by IMSI, up to the accept or reject. */
    private String update(TestTower tower, String imei) {
        String channel = tower.access("05", "0508 70 00f110 fffe 33 " + TestTower.imsi("5550100"));
        assertEquals("051802", tower.nextLayer3());
        tower.tell(channel, "0559 08 " + imei);
        String answer = tower.nextLayer3();
        if (answer.startsWith("0502")) {
            tower.tell(channel, "051b");
        }
        tower.leave(channel);
        return answer;
    }

    @Test
    void anUpdateInAnotherLocationAreaKeepsTheSubscriberAttached() {
        assertTrue(update(west, TowerStage.IMEI).startsWith("050200f1100001"));

        assertTrue(update(east, TowerStage.IMEI).startsWith("050200f1100002"));

        assertEquals(List.of(new ExchangeEvent.Attached(NUMBER)), stage.events);
        assertEquals(1, stage.exchange.attachedCount());
        assertEquals(1, stage.exchange.linkCount());
    }

    @Test
    void pagingGoesToTheTowersOfTheLocationAreaOnly() {
        update(west, TowerStage.IMEI);
        String caller = east.register("5550200", TowerStage.OTHER_IMEI);
        west.received.clear();

        String channel = east.access("e1", "0524 71 03331981 05f4" + caller);
        east.nextLayer3();
        east.tell(channel, "0345 0406600402000581 5e0581550501f0");

        assertEquals(RslType.PAGING_COMMAND, west.next(RslType.PAGING_COMMAND).type());
        while (!east.received.isEmpty()) {
            assertTrue(!east.received.remove().toString().startsWith("0c15"), "no mobile is paged in area 2");
        }
    }

    @Test
    void anotherEquipmentIsRefusedWhileTheFirstOneMayAnswer() {
        update(west, TowerStage.IMEI);

        assertEquals("050416", update(east, TowerStage.OTHER_IMEI));
    }

    @Test
    void anotherEquipmentIsAdmittedWhenTheFirstOneHasNotAnsweredItsPaging() {
        update(west, TowerStage.IMEI);
        String caller = west.register("5550200", TowerStage.THIRD_IMEI);
        String channel = west.access("e1", "0524 71 03331981 05f4" + caller);
        west.nextLayer3();
        west.tell(channel, "0345 0406600402000581 5e0581550501f0");
        stage.passMillis(10_000);

        assertTrue(update(east, TowerStage.OTHER_IMEI).startsWith("0502"));
    }

    @Test
    void aMobileThatDetachesIsForgottenWithItsRadioConnection() {
        update(west, TowerStage.IMEI);

        String channel = west.access("05", "0501 33 " + TestTower.imsi("5550100"));
        stage.passMillis(10);
        west.leave(channel);

        assertEquals(0, stage.exchange.attachedCount());
        assertEquals(0, stage.exchange.linkCount());
    }

    @Test
    void aMobileThatIsNotHeardForTwoPeriodsOfUpdatingAndAMinuteIsDetached() {
        update(west, TowerStage.IMEI);
        stage.passMillis(30 * 60_000);
        assertTrue(update(stage.tower("north arfcn=120 bsic=12 lac=1", "6971/0/0"), TowerStage.IMEI)
                .startsWith("0502"));
        stage.passMillis(61 * 60_000 - 2_001);
        assertEquals(1, stage.exchange.attachedCount());

        stage.passMillis(1);

        assertEquals(0, stage.exchange.attachedCount());
        assertEquals(0, stage.exchange.linkCount());
    }

    @Test
    void aBroadcastGoesOnceToEachTowerHoweverManyMobilesItHas() {
        update(west, TowerStage.IMEI);
        west.register("5550200", TowerStage.OTHER_IMEI);
        west.received.clear();
        east.received.clear();

        stage.exchange.broadcast(stage.nowNanos, BroadcastOrder.once(50, "Attention"));

        for (TestTower tower : List.of(west, east)) {
            assertEquals(1, tower.received.size());
            assertTrue(tower.received.remove().toString().startsWith("0c1d019029002a58"));
        }
    }
}
