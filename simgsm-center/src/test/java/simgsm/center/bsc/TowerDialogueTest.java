package simgsm.center.bsc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslType;
import simgsm.air.Msisdn;
import simgsm.center.msc.ExchangeEvent;

/** The dialogues of one tower with the controller, octet by octet as osmo-bsc 1.9 has them where it has the same. */
class TowerDialogueTest {
    private final TowerStage stage = new TowerStage();

    @Test
    void aTowerGetsTheSystemInformationThatOsmoBscSends() {
        stage.east();
        TestTower west = stage.west();

        west.down(
                "0c1101801e01271755061900000008000000000000000000000000e504002b",
                "0c1101801e02271759061a00002000000000000000000000000000ffe50400",
                "0c1101801e03271749061b1b3900f1100001c90305274e40e50400292b2b2b",
                "0c1101801e04271731061c00f11000014e40e504002b2b2b2b2b2b2b2b2b2b",
                "101a1e050b001349061d10002000000000000000000000000000",
                "101a1e060b000d2d061e1b3900f110000127ff2b");
        west.quiet();
    }

    @Test
    void aTowerThatConnectsLaterIsListedByTheOthers() {
        TestTower east = stage.east();
        east.received.clear();

        stage.west();

        east.down(
                "0c1101801e02271759061a00000008000000000000000000000000ffe50400",
                "101a1e050b001349061d10000008000000000000000000000000");
        east.quiet();
    }

    @Test
    void aTowerThatTellsNoCellGetsOneThatNoOtherHasAlsoWhenItComesBack() {
        TestTower first = stage.tower("", "6969/0/0");
        TestTower second = stage.tower("", "6970/0/0");
        second.received.clear();
        first.vanish();
        second.received.clear();

        stage.tower("", "6969/0/0");

        // The neighbour that came back is ARFCN 100 again, and not the 110 of this cell.
        second.down(
                "0c1101801e02271759061a00000008000000000000000000000000ffe50400",
                "101a1e050b001349061d10000008000000000000000000000000");
        second.quiet();
    }

    @Test
    void linkErrorsOfMobilesDoNotCountAgainstTheirTower() {
        TestTower west = stage.west();
        String channel = west.access("05", "0508 70 00f110 fffe 33 " + TestTower.imsi("5550100"));
        for (int i = 0; i < 200; i++) {
            west.up("0203 01" + channel + "0200 160101");
        }

        assertEquals(Optional.empty(), west.closedFor);
        west.tell(channel, "0559 08 " + TowerStage.IMEI);
        west.next(RslType.DATA_REQUEST);
    }

    /** As Wireshark reads them; osmo-bsc 1.9 divides them likewise, and counts the first frequency of a range twice. */
    @Test
    void neighboursOfAnotherBandAreListedInTypes2terAnd5ter() {
        stage.tower("e arfcn=0 bsic=14", "6973/0/0");
        stage.tower("f arfcn=600 bsic=14", "6974/0/0");
        stage.tower("b arfcn=975 bsic=11", "6970/0/0");
        stage.tower("c arfcn=512 bsic=12", "6971/0/0");
        stage.tower("d arfcn=885 bsic=13", "6972/0/0");
        TestTower a = stage.tower("a arfcn=100 bsic=10", "6969/0/0");

        a.down("0c1101801e01271755061900000008000000000000000000000000e504002b");
        a.down("0c1101801e02271759061a8fe78000000000004000000000000000ffe50400");
        a.down("0c1101801e0b2717490603890016078000000000000000000000002b2b2b2b");
        a.down("0c1101801e03271749061b1b3900f1100001c90305274e40e50400292b2b2b");
        a.down("0c1101801e04271731061c00f11000014e40e504002b2b2b2b2b2b2b2b2b2b");
        a.down("101a1e050b001349061d9fe78000000000004000000000000000");
        a.down("101a1e0e0b001349060699001607800000000000000000000000");
        a.down("101a1e060b000d2d061e1b3900f110000127ff2b");
    }

    @Test
    void aListIsEndedWithTheLastTowerOfItsBand() {
        TestTower west = stage.west();
        TestTower far = stage.tower("far arfcn=600 bsic=14 lac=1", "6974/0/0");
        west.received.clear();

        far.vanish();

        west.down(
                "0c1101801e02271759061a00000000000000000000000000000000ffe50400",
                "101a1e050b001349061d10000000000000000000000000000000",
                "0c1101801e0b",
                "101a1e0e");
    }

    @Test
    void aTowerWhoseFrequencyFitsNoListWithTheOthersIsToldWhyAndTheOthersStay() {
        for (int i = 0; i < 18; i++) {
            stage.tower("t" + i + " arfcn=" + (512 + 20 * i) + " bsic=1", 7000 + i + "/0/0");
        }
        stage.tower("far arfcn=885 bsic=1", "7100/0/0");
        assertEquals(19, stage.exchange.towers().size());

        TestTower other = stage.tower("west arfcn=100 bsic=1", "7101/0/0");

        String reason = other.closedFor.orElse("");
        assertTrue(reason.startsWith("is no tower: no frequency list has room for the 19 ARFCNs [512, "), reason);
        assertEquals(19, stage.exchange.towers().size());
    }

    @Test
    void locationUpdatingRunsFromTheChannelRequestToTheFreeChannel() {
        TestTower west = stage.west();
        west.received.clear();

        west.up("0c13 0188 13 05 1234 1103");
        west.down("0821 0120 0300 0604 00030100 0506 64204064 7200 0400 0d0e 1803 1f00");
        west.up("0822 0120 08 0000");
        west.down("0c16 0190 2b17 2d063f03 204064 051234 0300 2b2b2b2b2b2b2b2b2b2b2b");
        west.up("0206 0120 0200 0b0012 0508 70 00f110 fffe 33 " + TestTower.imsi("5550100"));
        west.down("0301 0120 0200 0b0003 051802");
        west.tell("20", "0559 08 " + TowerStage.IMEI);
        assertTrue(west.nextLayer3().startsWith("050200f11000011705f4"));
        west.tell("20", "051b");
        assertTrue(west.nextLayer3().startsWith("0532"));
        west.down("0301 0120 0200 0b0003 060d00", "0825 0120");
        west.up("0209 0120 0200");
        stage.passMillis(1_999);
        west.quiet();
        stage.passMillis(1);
        west.down("082e 0120");
        assertEquals(Map.of("west", 10L), stage.exchange.towers());
        west.up("0833 0120");
        assertEquals(Map.of("west", 11L), stage.exchange.towers());
        assertEquals(List.of(new ExchangeEvent.Attached(new Msisdn("5550100"))), stage.events);
    }

    @Test
    void aMessageIsSubmittedAndDeliveredOnSapi3() {
        TestTower west = stage.west();
        String sender = west.register("5550100", TowerStage.IMEI);
        String receiver = west.register("5550200", TowerStage.OTHER_IMEI);

        String channel = west.access("11", "0524 74 03331981 05f4" + sender);
        assertEquals("0521", west.nextLayer3());
        west.up("0206 01" + channel + "0203");
        west.tellSms(channel, "3901 17 00 01 00 0291f1 10 1101 0781 550502f0 0000 a7 04 f4f29c0e");
        west.down("0301 01" + channel + "0203 0b0002 b904");
        // Stored: the sender gets its acknowledgement, the receiver is paged.
        assertTrue(west.nextLayer3().startsWith("b901"));
        west.down("0c15 0190 0e00 0c05 f4" + receiver + "2800");
        west.tellSms(channel, "3904");
        assertEquals("060d00", west.nextLayer3());
        west.down("0825 01" + channel, "0207 01" + channel + "0203 1401");
        west.up("0208 01" + channel + "0203");

        west.up("0c13 0188 13 91 4444 1100");
        assertEquals("0c16", answerActivation(west, "28"));
        west.up("0206 0128 0200 0b000d 0627 07 03331981 05f4" + receiver);
        west.down("0204 0128 0203");
        west.quiet();
        west.up("0205 0128 0203");
        String delivery = west.nextLayer3();
        assertTrue(delivery.startsWith("0901") && delivery.endsWith("04f4f29c0e"), delivery);
    }

    private String answerActivation(TestTower tower, String channel) {
        assertEquals("082101" + channel, tower.received.remove().toString().substring(0, 8));
        tower.up("0822 01" + channel + "080000");
        return tower.received.remove().toString().substring(0, 4);
    }
}
