package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.Direction;
import simgsm.air.LocationArea;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingReject;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.MobilityManagement.LocationUpdatingType;
import simgsm.air.MobilityManagement.MmInformation;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.RejectCause;
import simgsm.rr.SystemInformation;
import simgsm.rr.SystemInformation.ControlChannel;
import simgsm.rr.SystemInformation.RandomAccess;
import simgsm.rr.SystemInformation.SelectionParameters;

/** How a station that moves through a town keeps its location known. */
class LocationUpdatingTest {
    private static final long SIX_MINUTES = 360 * Scene.SECOND;
    private static final LocationArea SECOND_AREA = new LocationArea("001", "01", 2);

    private Scene scene;

    @BeforeEach
    void register() {
        scene = Scene.registered();
    }

    private void camp(LocationArea area, int t3212) {
        SystemInformation.Type3 cell = new SystemInformation.Type3(
                1,
                area,
                new ControlChannel(true, 1, true, 2, t3212),
                32,
                new SelectionParameters(4, 5, 5),
                new RandomAccess(7, 9, false),
                Optional.empty());
        scene.frame(
                IpaFrame.RSL,
                new RslMessage.BroadcastInformation(RslMessage.BroadcastInformation.TYPE_3, cell.encode()).encode());
    }

    private LocationUpdatingRequest accept(LocationArea area) {
        LocationUpdatingRequest request = scene.expectFirst(LocationUpdatingRequest.class);
        scene.down(new LocationUpdatingAccept(area, Optional.empty()));
        scene.releaseChannel();
        return request;
    }

    @Test
    void aCellOfTheSameAreaChangesNothing() {
        camp(LocationArea.TEST, 0);
        scene.expectNothing();
    }

    @Test
    void aCellOfAnotherAreaIsFollowedByOneNormalUpdate() {
        camp(SECOND_AREA, 0);

        LocationUpdatingRequest request = accept(SECOND_AREA);
        assertEquals(LocationUpdatingType.NORMAL, request.updatingType());
        assertEquals(LocationArea.TEST, request.oldArea());
        scene.expectNothing();
        assertEquals(List.of(), scene.reported.lines());
    }

    @Test
    void onARadioConnectionTheUpdateWaitsForItsEnd() {
        scene.page(Scene.TMSI);
        scene.expectFirst(PagingResponse.class);
        camp(SECOND_AREA, 0);
        scene.expectNothing();

        scene.releaseChannel();

        assertEquals(LocationUpdatingType.NORMAL, accept(SECOND_AREA).updatingType());
    }

    @Test
    void aStationThatFoundNoNetworkRegistersAsSoonAsACellIsThere() {
        scene.linkDown();
        scene.linkUp();
        scene.identify();
        for (long pause = Scene.SECOND; pause < 16 * Scene.SECOND; pause *= 2) {
            scene.expectFirst(LocationUpdatingRequest.class);
            scene.pass(20 * Scene.SECOND);
            scene.expectReleaseIndication();
            scene.pass(pause);
        }
        scene.expectFirst(LocationUpdatingRequest.class);
        scene.pass(20 * Scene.SECOND);
        scene.expectReleaseIndication();
        camp(SECOND_AREA, 0);
        assertEquals(LocationUpdatingType.IMSI_ATTACH, accept(SECOND_AREA).updatingType());
        assertEquals(List.of("unregistered", "registered 5550100"), scene.reported.lines());
        scene.pass(60 * Scene.SECOND);
        scene.expectNothing();
    }

    @Test
    void aRefusedStationKeepsItsPauseInAnotherCell() {
        scene.linkDown();
        scene.linkUp();
        scene.identify();
        scene.expectFirst(LocationUpdatingRequest.class);
        scene.down(new LocationUpdatingReject(RejectCause.ILLEGAL_MS));
        scene.releaseChannel();
        camp(SECOND_AREA, 0);
        scene.pass(Scene.SECOND - 1);
        scene.expectNothing();
        scene.pass(1);
        scene.expectFirst(LocationUpdatingRequest.class);
    }

    private void beginOverTowers(int t3212) {
        scene.linkDown();
        scene.linkUp();
        camp(LocationArea.TEST, t3212);
        scene.identify();
    }

    private void reject(int cause) {
        scene.expectFirst(LocationUpdatingRequest.class);
        scene.down(new LocationUpdatingReject(RejectCause.ofCode(cause, Direction.DOWNLINK)));
        scene.releaseChannel();
    }

    /** TS 24.008, 4.4.4.7 and 4.4.4.9; osmo-hlr's wrong key is cause 3, its cause 96 and a full VLR's 22 are others. */
    @ParameterizedTest
    @ValueSource(ints = {17, 22, 96, 111})
    void overTowersARefusalIsFollowedByFourAttemptsAtT3211AndThenByT3212(int cause) {
        beginOverTowers(2);
        reject(cause);
        for (int attempt = 2; attempt <= 4; attempt++) {
            scene.pass(15 * Scene.SECOND - 1);
            scene.expectNothing();
            scene.pass(1);
            reject(cause);
        }
        scene.pass(2 * SIX_MINUTES - 1);
        scene.expectNothing();
        scene.pass(1);
        accept(LocationArea.TEST);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 6})
    void overTowersARefusedSimIsInvalidUntilTheStationIsSwitchedOff(int cause) {
        beginOverTowers(1);
        reject(cause);
        camp(SECOND_AREA, 1);
        scene.linkDown();
        scene.linkUp();
        camp(LocationArea.TEST, 1);
        scene.identify();
        scene.pass(3_600 * Scene.SECOND);
        scene.expectNothing();
        assertEquals(List.of("unregistered", "unregistered " + cause), scene.reported.lines());

        scene.station.powerOff();
        scene.station.powerOn();
        accept(LocationArea.TEST);
    }

    @ParameterizedTest
    @ValueSource(ints = {11, 12, 13, 15})
    void overTowersAnAreaThatIsNotAllowedIsLeftAloneAndAnotherOneTried(int cause) {
        beginOverTowers(1);
        reject(cause);
        scene.pass(3_600 * Scene.SECOND);
        scene.expectNothing();
        camp(SECOND_AREA, 1);
        accept(SECOND_AREA);
    }

    private void expectPeriodicUpdateAfter(long nanos) {
        scene.pass(nanos - 1);
        scene.expectNothing();
        scene.pass(1);
        assertEquals(LocationUpdatingType.PERIODIC, accept(SECOND_AREA).updatingType());
    }

    @Test
    void aShorterT3212CountsAtOnceAsTheRestModuloTheNewValue() {
        camp(SECOND_AREA, 5);
        accept(SECOND_AREA);
        scene.pass(SIX_MINUTES / 2);

        camp(SECOND_AREA, 1);

        // 27 minutes were left: 27 modulo 6 is 3.
        expectPeriodicUpdateAfter(SIX_MINUTES / 2);
        expectPeriodicUpdateAfter(SIX_MINUTES);
    }

    @Test
    void aLongerT3212LetsTheRunningTimeEnd() {
        camp(SECOND_AREA, 1);
        accept(SECOND_AREA);
        scene.pass(SIX_MINUTES / 3);

        camp(SECOND_AREA, 5);

        expectPeriodicUpdateAfter(SIX_MINUTES - SIX_MINUTES / 3);
        expectPeriodicUpdateAfter(5 * SIX_MINUTES);
    }

    @Test
    void aT3212ThatIsWithdrawnEndsPeriodicUpdating() {
        camp(SECOND_AREA, 1);
        accept(SECOND_AREA);

        camp(SECOND_AREA, 0);

        scene.pass(10 * SIX_MINUTES);
        scene.expectNothing();
    }

    @Test
    void aT3212ThatIsIntroducedIsFollowedByAFirstUpdateWithinIt() {
        camp(SECOND_AREA, 0);
        accept(SECOND_AREA);

        camp(SECOND_AREA, 1);

        scene.pass(SIX_MINUTES);
        assertEquals(LocationUpdatingType.PERIODIC, accept(SECOND_AREA).updatingType());
    }

    @Test
    void aConnectionOnWhichTheNetworkAnswersBeginsThePeriodAnew() {
        camp(SECOND_AREA, 1);
        accept(SECOND_AREA);
        scene.pass(SIX_MINUTES - Scene.SECOND);
        scene.page(Scene.TMSI);
        scene.expectFirst(PagingResponse.class);
        scene.down(new MmInformation("Town"));
        scene.releaseChannel();

        expectPeriodicUpdateAfter(SIX_MINUTES);
    }

    @Test
    void withT3212TheLocationIsUpdatedEachTimeItExpires() {
        camp(SECOND_AREA, 1);
        accept(SECOND_AREA);
        for (int i = 0; i < 3; i++) {
            scene.pass(SIX_MINUTES - 1);
            scene.expectNothing();
            scene.pass(1);
            assertEquals(LocationUpdatingType.PERIODIC, accept(SECOND_AREA).updatingType());
        }
    }
}
