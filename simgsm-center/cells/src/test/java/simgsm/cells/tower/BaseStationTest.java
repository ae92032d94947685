package simgsm.cells.tower;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.air.MobileIdentity;
import simgsm.cells.town.Tower;
import simgsm.cells.town.TownPlace;
import simgsm.octets.OctetString;
import simgsm.timer.Timers;

/** One tower's link to its controller: lists of neighbours, and refusals. */
class BaseStationTest {
    private static final String CELL = "0c1101801e03271749061b1b3900f1100001c90305274e40e50400292b2b2b";

    private final List<TowerRefused> refusals = new ArrayList<>();
    private final BaseStation tower = new BaseStation(
            new Tower("west", new TownPlace(0, 0), 30, 43, 600, 10, 1, 6969),
            32,
            new Timers(),
            new TowerListener() {
                @Override
                public void paged(BaseStation from, int group, MobileIdentity identity) {}

                @Override
                public void broadcast(BaseStation from, OctetString page) {}

                @Override
                public void refused(TowerRefused refusal) {
                    refusals.add(refusal);
                }

                @Override
                public void changed(BaseStation from) {}
            },
            AirInterface.STANDARD);

    private final class Link implements TowerPort {
        @Override
        public void send(IpaFrame frame) {}

        @Override
        public Optional<SpeechSocket> openSpeech(Consumer<byte[]> received) {
            return Optional.empty();
        }

        @Override
        public void drop(String reason) {
            tower.disconnected();
        }
    }

    @BeforeEach
    void connect() {
        tower.connected(new Link());
        down(new CcmMessage.IdentityRequest());
    }

    private void down(CcmMessage message) {
        tower.frameArrived(new IpaFrame(IpaFrame.CCM, CcmCodec.encode(message)));
    }

    private void down(String rsl) {
        tower.frameArrived(new IpaFrame(IpaFrame.RSL, OctetString.ofHex(rsl).toArray()));
    }

    /** Octets of osmo-bsc 1.9 for ARFCN 0 and 975, and our own for two of the other band. */
    @Test
    void reportsNumberTheCellsBandBeforeTheOtherOneUntilALargerListEnds() {
        down("101a1e050b001349061d9fe78000000000004000000000000000");
        down("101a1e0e0b001349060699001607800000000000000000000000");
        assertEquals(List.of(975, 0, 512, 600, 885), tower.neighbours());

        down("101a1e0d0b0013490605100000000000000000000000000000" + "08");
        assertEquals(List.of(4, 975, 0, 512, 600, 885), tower.neighbours());

        down("101a1e0e");
        assertEquals(List.of(4, 975, 0), tower.neighbours());
    }

    @Test
    void aRefusalIsToldOnceWithTheControllersReasonUntilTheCellIsInService() {
        for (int i = 0; i < 2; i++) {
            down(new CcmMessage.IdentityResponse("unit id 6969/0/0 is in use from 192.0.2.1", ""));
            tower.disconnected();
            assertEquals("refused", tower.state());
            tower.connected(new Link());
            down(new CcmMessage.IdentityRequest());
        }
        assertEquals(List.of(new TowerRefused("west", "unit id 6969/0/0 is in use from 192.0.2.1")), refusals);

        down(CELL);
        assertEquals("on", tower.state());
        tower.disconnected();
        assertEquals("searching", tower.state());
    }

    @Test
    void aLinkThatEndsAfterTheUnitIdWithoutAReasonIsARefusal() {
        tower.disconnected();

        assertEquals("refused", tower.state());
        assertEquals(
                "unit id 6969/0/0 is not configured there, or has no OML link yet",
                refusals.get(0).text());
    }

    @Test
    void aLinkThatEndsBeforeTheUnitIdIsNoRefusal() {
        down(CELL);
        tower.disconnected();
        tower.connected(new Link());
        tower.disconnected();

        assertEquals(List.of(), refusals);
        assertEquals("searching", tower.state());
    }
}
