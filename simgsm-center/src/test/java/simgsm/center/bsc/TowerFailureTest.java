package simgsm.center.bsc;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslType;
import simgsm.center.msc.call.CallProgress;

/** Calls over towers when a tower refuses, fails or dies: what ends, and what goes on. */
class TowerFailureTest extends TowerCalls {
    private static final int LINK_ENDS_AFTER = 100;

    @Test
    void aTowerThatRefusesSpeechLosesTheCallAndKeepsItsLink() {
        dial(west);
        String traffic = TestTower.channelOf(west.next(RslType.CHANNEL_ACTIVATION));
        west.up("0822 01" + traffic + "080000");
        for (int i = 0; i <= LINK_ENDS_AFTER; i++) {
            west.up("7e72 01" + traffic + "1a012f");
        }
        west.received.clear();
        west.up("0206 01" + traffic + "0200");
        west.tell(traffic, "062900");

        assertEquals("832502e2a2", west.nextLayer3());
        assertEquals(Optional.empty(), west.closedFor);
    }

    @Test
    void aTowerThatRefusesOurPortLosesTheCallAndKeepsItsLink() {
        String[] channels = activeCall();

        west.up("7e75 01" + channels[0] + "f80001 1a012f");

        assertEquals("832502e2a2", west.nextLayer3());
        assertEquals(Optional.empty(), west.closedFor);
    }

    @Test
    void aMobileWhoseReportsCannotBeReadDoesNotCostTheTowerItsLink() {
        String[] channels = activeCall();
        for (int i = 0; i <= LINK_ENDS_AFTER; i++) {
            west.up("0828 01" + channels[0] + "1b" + String.format("%02x", i) + "1903 3f3f 00 0400 0a0000 0b0002 0615");
        }

        assertEquals(Optional.empty(), west.closedFor);
        assertEquals(CallProgress.ACTIVE, progress());
    }

    @Test
    void aDirectedRetryThatFailsDoesNotBeginTheFiveSecondsAnew() {
        occupyTrafficChannels();
        String signalling = dial(west);
        stage.passMillis(4_000);
        measure(west, signalling, 0, 50, 30);
        refuseActivation(east);
        west.received.clear();

        stage.passMillis(999);
        assertFalse(
                west.received.stream().anyMatch(message -> message.toString().contains("832502e2a2")));
        stage.passMillis(1);

        assertEquals("832502e2a2", west.nextLayer3());
    }

    @Test
    void aCallThatReturnsFromADirectedRetryAfterItsFiveSecondsEnds() {
        occupyTrafficChannels();
        String signalling = dial(west);
        stage.passMillis(4_000);
        measure(west, signalling, 0, 50, 30);
        east.up("0822 0109 08 0000");
        stage.passMillis(2_000);
        west.received.clear();

        west.tell(signalling, "06286f");
        stage.passMillis(0);

        assertEquals("832502e2a2", west.nextLayer3());
    }

    @Test
    void aDirectedRetryThatFailsDoesNotCostACallItsPlaceInTheQueue() {
        String third = west.register("5550300", TowerStage.THIRD_IMEI);
        List<String> occupied = occupyTrafficChannels();
        // A second SDCCH comes back, too.
        west.up("0823 0120 1a0100");
        west.up("0833 0120");
        String first = dial(west);
        stage.passMillis(500);
        String second = west.access("e1", "0524 71 03331981 05f4" + third);
        west.nextLayer3();
        west.tell(second, SETUP);
        measure(west, first, 0, 50, 30);
        refuseActivation(east);
        west.received.clear();

        west.up("0823 01" + occupied.get(0) + "1a0100");
        west.up("0833 01" + occupied.get(0));

        west.up("0822 01" + TestTower.channelOf(west.next(RslType.CHANNEL_ACTIVATION)) + "080000");
        assertEquals(first, TestTower.channelOf(west.next(RslType.DATA_REQUEST)));
    }

    private static void refuseActivation(TestTower tower) {
        String channel = TestTower.channelOf(tower.next(RslType.CHANNEL_ACTIVATION));
        tower.up("0823 01" + channel + "1a0120");
    }

    @Test
    void aMobileWhoseNewTowerDiesInAHandoverComesBackAndItsCallGoesOn() {
        String[] channels = activeCall();
        TestTower north = stage.tower("north arfcn=120 bsic=12 lac=1 cell=6971 tch=7", "6971/0/0");
        moveToNorth(channels[0]);
        north.up("0822 0109 08 0000");
        assertEquals("062b0c78", west.nextLayer3().substring(0, 8));

        north.vanish();
        assertEquals(CallProgress.ACTIVE, progress());
        west.received.clear();
        west.tell(channels[0], "062803");

        west.quiet();
        east.media.get(0).speak(rtp(1));
        assertArrayEquals(rtp(1), west.media.get(0).heard.get(0));
        west.tell(channels[0], "0365 02e090");
        assertEquals("832d", west.nextLayer3().substring(0, 4));
    }

    @Test
    void aMobileThatDoesNotComeBackFromADeadTowerIsClearedAfterT3103() {
        String[] channels = activeCall();
        TestTower north = stage.tower("north arfcn=120 bsic=12 lac=1 cell=6971 tch=7", "6971/0/0");
        moveToNorth(channels[0]);
        north.up("0822 0109 08 0000");
        stage.passMillis(1_000);
        north.vanish();
        stage.passMillis(3_999);
        assertEquals(CallProgress.ACTIVE, progress());

        stage.passMillis(1);

        assertEquals(CallProgress.RELEASED, progress());
        assertTrue(west.received.stream().anyMatch(message -> message.toString().startsWith("082e")));
    }

    @Test
    void aMobileWhoseOldTowerDiesInAHandoverGoesOnInTheNewCell() {
        String[] channels = activeCall();
        measure(west, channels[0], 5, 20, 40);
        east.up("0822 010a 08 0000");
        west.vanish();
        assertEquals(CallProgress.ACTIVE, progress());

        east.up("0827 010a 1100");
        east.tell("0a", "062c00");
        stage.passMillis(10_000);

        assertEquals(CallProgress.ACTIVE, progress());
    }

    @Test
    void aTowerThatConnectsAgainFromItsHostTakesTheOldLinksPlaceAfterTenSeconds() {
        String plan = "south arfcn=130 bsic=13 lac=1 cell=6972 tch=7";
        TestTower first = stage.tower(plan, "6972/0/0", "192.0.2.1:1000");
        stage.passMillis(9_999);
        TestTower early = stage.tower(plan, "6972/0/0", "192.0.2.1:1001");
        assertEquals(Optional.of("is no tower: unit id 6972/0/0 was connected less than 10 s ago"), early.closedFor);
        assertEquals(Optional.empty(), first.closedFor);

        stage.passMillis(1);
        TestTower second = stage.tower(plan, "6972/0/0", "192.0.2.1:1002");

        assertEquals(Optional.of("the tower has connected again"), first.closedFor);
        assertEquals(Optional.empty(), second.closedFor);
    }

    @Test
    void anotherHostTakesATowersPlaceOnlyWhenTheTowerIsSilent() {
        String plan = "south arfcn=130 bsic=13 lac=1 cell=6972 tch=7";
        TestTower first = stage.tower(plan, "6972/0/0", "192.0.2.1:1000");
        stage.passMillis(20_000);
        TestTower intruder = stage.tower(plan, "6972/0/0", "192.0.2.2:1000");
        assertEquals(Optional.of("is no tower: unit id 6972/0/0 is in use from 192.0.2.1"), intruder.closedFor);
        assertEquals(Optional.empty(), first.closedFor);

        stage.passMillis(70_000);
        TestTower moved = stage.tower(plan, "6972/0/0", "192.0.2.2:1001");

        assertEquals(Optional.of("the tower has connected again"), first.closedFor);
        assertEquals(Optional.empty(), moved.closedFor);
    }

    @Test
    void aLinkThatCannotBeTheTowerDoesNotEndTheOldOne() {
        TestTower first = stage.tower("south arfcn=130 bsic=13 lac=1", "6972/0/0", "192.0.2.1:1000");
        stage.passMillis(20_000);

        TestTower far = stage.tower("south arfcn=1024 bsic=13 lac=1", "6972/0/0", "192.0.2.1:1001");

        assertTrue(far.closedFor.orElse("").startsWith("is no tower: ARFCN 1024"), far.closedFor.toString());
        assertEquals(Optional.empty(), first.closedFor);
    }

    /** A report that moves the mobile of west to the second neighbour, north: frequency index 1, BSIC 12, -70 dBm. */
    private void moveToNorth(String channel) {
        west.up("0828 01" + channel + "1b05 1903 141400 0400 0a0000 0b0012 0615 141400 68 0980" + "00".repeat(10));
    }
}
