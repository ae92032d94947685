package simgsm.cells.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static simgsm.cells.network.TownScene.MILLI;
import static simgsm.cells.network.TownScene.SDCCH;
import static simgsm.cells.network.TownScene.TCH;

import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl.Connect;
import simgsm.air.CallControl.ConnectAcknowledge;
import simgsm.air.ChannelDescription;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.AssignmentCommand;
import simgsm.air.RadioResource.CellDescription;
import simgsm.air.RadioResource.ChannelModeModify;
import simgsm.air.RadioResource.HandoverCommand;
import simgsm.air.TransactionIdentifier;
import simgsm.cells.mobile.MobileRadioTable.MobileRadioState;
import simgsm.octets.OctetString;

/** Channels that end, are taken or do not fit while a mobile changes to them or from them. */
class ChannelChangeTest {
    private static final ChannelDescription WEST_TCH = new ChannelDescription(TCH, 2, 100);
    private static final TransactionIdentifier TRANSACTION = new TransactionIdentifier(0, true);
    private static final int HALF_RATE = 0x05;
    private static final int ENHANCED_FULL_RATE = 0x21;

    private final TownScene scene = new TownScene();
    private TownScene.Terminal terminal;

    @BeforeEach
    void connect() throws ProtocolViolation {
        terminal = scene.onSignallingChannel();
    }

    private void assign(int mode) {
        scene.west.activate(TCH, 1, Optional.empty());
        scene.west.down(SDCCH, new AssignmentCommand(WEST_TCH, 5, mode));
    }

    private void release(TownScene.Controller tower) {
        tower.down(RslPdu.of(RslType.RF_CHANNEL_RELEASE, TCH));
        tower.discardReports();
        tower.expect(RslType.RF_CHANNEL_RELEASE_ACKNOWLEDGE);
    }

    /** 8307 is CONNECT, 830f the message after it. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aConnectOfAPhoneThatAnswersAtOnceIsHeldUntil100MillisAfterTheFirstModifiedConnection(boolean isAssigned)
            throws ProtocolViolation {
        if (isAssigned) {
            assign(1);
            scene.pass(100 * MILLI);
        }
        terminal.send(false, new Connect(TRANSACTION, Optional.empty()));
        terminal.send(false, new ConnectAcknowledge(TRANSACTION));
        if (!isAssigned) {
            scene.pass(100 * MILLI);
            scene.west.discardReports();
            scene.west.expectNothing();
            assign(1);
            scene.pass(100 * MILLI);
        }
        scene.connectSpeechAfterAssignment();
        scene.pass(99 * MILLI);
        scene.west.discardReports();
        scene.west.expectNothing();
        scene.pass(2 * MILLI);
        scene.west.discardReports();
        assertEquals("8307", scene.west.expectLayer3().substring(0, 4));
        assertEquals("830f", scene.west.expectLayer3().substring(0, 4));
    }

    @Test
    void aConnectIsHeldForOneSecondWhenNoSpeechConnectionIsModified() throws ProtocolViolation {
        terminal.send(false, new Connect(TRANSACTION, Optional.empty()));
        scene.pass(999 * MILLI);
        scene.west.discardReports();
        scene.west.expectNothing();
        scene.pass(2 * MILLI);
        scene.west.discardReports();
        assertEquals("8307", scene.west.expectLayer3().substring(0, 4));
    }

    @Test
    void aConnectLaterInTheCallIsNotHeld() throws ProtocolViolation {
        inCall();
        scene.pass(101 * MILLI);
        scene.west.discardReports();
        terminal.send(false, new Connect(TRANSACTION, Optional.empty()));
        assertEquals("8307", scene.west.expectLayer3().substring(0, 4));
    }

    @Test
    void aTargetThatIsFreedOnTheWayIsNotEstablished() throws ProtocolViolation {
        assign(1);
        scene.pass(20 * MILLI);
        release(scene.west);
        scene.pass(100 * MILLI);

        scene.west.discardReports();
        RslPdu failure = scene.west.expect(RslType.DATA_INDICATION);
        assertEquals(SDCCH, failure.channel());
        assertEquals("062f6f", failure.value(RslElement.L3_INFORMATION).toString());
        scene.west.expectNothing();
        assertEquals(MobileRadioState.DEDICATED, terminal.mobile.state());
    }

    @Test
    void aTargetThatIsGivenToAnotherMobileOnTheWayIsNotTakenFromIt() throws ProtocolViolation {
        assign(1);
        TownScene.Terminal other = scene.new Terminal("5550200");
        scene.network.place("5550200", new simgsm.cells.town.TownPlace(500, 0));
        other.register();
        release(scene.west);
        scene.west.activate(TCH, 0, Optional.empty());
        scene.west.grant(TCH, scene.west.expectAccess());
        scene.west.expect(RslType.ESTABLISH_INDICATION);
        scene.pass(100 * MILLI);

        scene.west.discardReports();
        assertEquals("062f6f", scene.west.expectLayer3());
        assertEquals(TCH, other.mobile.channel().orElseThrow().number());
    }

    @Test
    void anOldChannelThatIsFreedDuringAHandoverIsNotEstablishedAgain() throws ProtocolViolation {
        inCall();
        scene.commandHandover(77);
        scene.pass(100 * MILLI);
        release(scene.west);
        scene.pass(1_000 * MILLI);

        scene.west.expectNothing();
        scene.pass(480 * MILLI * TownScene.LINK_TIMEOUT);
        assertEquals("060d01", terminal.expectLayer3());
    }

    @Test
    void aTargetThatEndsAfterHandoverAccessSendsTheMobileBackAtOnce() throws ProtocolViolation {
        inCall();
        scene.network.place("5550100", new simgsm.cells.town.TownPlace(2_200, 0));
        scene.pass(480 * MILLI);
        scene.east.activate(TCH, 2, Optional.of(77));
        scene.commandHandover(77);
        scene.pass(21 * MILLI);
        scene.east.expect(RslType.HANDOVER_DETECTION);
        release(scene.east);

        scene.west.discardReports();
        scene.west.expect(RslType.ESTABLISH_INDICATION);
        assertEquals("062803", scene.west.expectLayer3());
        scene.pass(1_000 * MILLI);
        scene.east.discardReports();
        scene.east.expectNothing();
    }

    private void inCall() throws ProtocolViolation {
        assign(1);
        scene.pass(100 * MILLI);
        scene.connectSpeechAfterAssignment();
    }

    /** TS 45.008, 4.2: the mobile confirms the level in use, which is the ordered one within its power class. */
    @ParameterizedTest
    @CsvSource({"14, 14", "5, 5", "3, 5", "0, 5"})
    void theReportsNameThePowerLevelThatIsOrdered(int ordered, int used) throws ProtocolViolation {
        scene.west.down(RslPdu.of(RslType.MS_POWER_CONTROL, TownScene.SDCCH).with(RslElement.MS_POWER, ordered));
        scene.west.up.clear();
        scene.pass(480 * MILLI);

        OctetString l1 = scene.west.expect(RslType.MEASUREMENT_RESULT).value(RslElement.L1_INFORMATION);
        assertEquals(used, l1.octet(0) >> 3);
    }

    /** TS 45.008, 5.2. */
    @Test
    void lostBlocksOfTheOldChannelDoNotCountOnTheNewOne() throws ProtocolViolation {
        scene.network.place("5550100", new simgsm.cells.town.TownPlace(60_000, 0));
        scene.pass(10 * 480 * MILLI);
        scene.network.place("5550100", new simgsm.cells.town.TownPlace(500, 0));
        scene.pass(480 * MILLI);
        scene.west.up.clear();
        assertEquals(TownScene.LINK_TIMEOUT - 10 + 2, terminal.mobile.link().count());
        assign(1);
        scene.pass(100 * MILLI);

        assertEquals(TownScene.LINK_TIMEOUT, terminal.mobile.link().count());
    }

    @ParameterizedTest
    @ValueSource(ints = {HALF_RATE, ENHANCED_FULL_RATE})
    void anAssignmentInAModeThatTheTerminalDoesNotHaveIsRefused(int mode) throws ProtocolViolation {
        assign(mode);

        assertEquals("062f09", scene.west.expectLayer3());
        assertEquals(SDCCH, terminal.mobile.channel().orElseThrow().number());
    }

    @Test
    void aHandoverInAModeThatTheTerminalDoesNotHaveIsRefusedWithoutLeaving() throws ProtocolViolation {
        inCall();
        scene.west.down(
                TCH,
                new HandoverCommand(
                        new CellDescription(11, 110),
                        new ChannelDescription(TCH, 3, 110),
                        77,
                        5,
                        Optional.of(ENHANCED_FULL_RATE)));

        scene.west.discardReports();
        assertEquals("062809", scene.west.expectLayer3());
        scene.west.expectNothing();
    }

    @ParameterizedTest
    @CsvSource({"1, 06170a406401", "0, 06170a406400", "5, 06170a406401", "33, 06170a406401"})
    void aModeIsAcknowledgedAndOneThatTheTerminalDoesNotHaveLeavesTheOldOne(int mode, String answer)
            throws ProtocolViolation {
        inCall();
        scene.west.down(TCH, new ChannelModeModify(WEST_TCH, mode));

        scene.west.discardReports();
        assertEquals(answer, scene.west.expectLayer3());
        terminal.expectNothing();
    }

    @Test
    void aFloodOfSpeechFromTheControllerIsCutTo200PacketsAnd100ASecond() throws ProtocolViolation {
        inCall();
        terminal.heardNanos.clear();
        flood(0, 1_000);
        assertEquals(200, terminal.heardNanos.size());

        scene.pass(1_000 * MILLI);
        flood(1_000, 1_000);
        assertEquals(300, terminal.heardNanos.size());
    }

    private void flood(int first, int count) {
        byte[] frame = new byte[33];
        frame[0] = (byte) 0xd0;
        for (int i = first; i < first + count; i++) {
            scene.west.speech.accept(new RtpPacket(RtpPacket.GSM_FULL_RATE, i, i * 160L, 1, frame).encode());
        }
    }
}
