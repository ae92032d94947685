package simgsm.cells.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.cells.network.TownScene.MILLI;
import static simgsm.cells.network.TownScene.SDCCH;
import static simgsm.cells.network.TownScene.TCH;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.abis.RslElement;
import simgsm.abis.RslMessage;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.abis.RtpPacket;
import simgsm.air.ChannelNumber;
import simgsm.air.ChannelNumber.Kind;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.LocationArea;
import simgsm.air.MeasurementResults;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.MobilityManagement.TmsiReallocationComplete;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.RadioResource.MeasurementReport;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.Tmsi;
import simgsm.cells.mobile.IdleSelection;
import simgsm.cells.mobile.MobileEvent;
import simgsm.cells.mobile.MobileRadioTable.MobileRadioState;
import simgsm.cells.town.TownPlace;
import simgsm.octets.OctetString;
import simgsm.rr.ImmediateAssignmentReject;
import simgsm.rr.RequestReference;

/** Mobiles and towers as one core: access, channels, paging, handover, loss of the radio link. */
class CellNetworkTest {
    private static final long SECOND = 1_000 * MILLI;

    @Test
    void aRegistrationAsksForAChannelAndCarriesTheFirstMessageOnIt() throws ProtocolViolation {
        TownScene scene = new TownScene();
        scene.network.place("5550100", new TownPlace(500, 0));
        TownScene.Terminal terminal = scene.new Terminal("5550100");
        terminal.register();

        RequestReference reference = scene.west.expectAccess();
        assertEquals(0, reference.access() >> 4, "location updating has cause 000x");
        scene.west.activate(SDCCH, 0, Optional.empty());
        scene.west.grant(SDCCH, reference);

        RslPdu establish = scene.west.expect(RslType.ESTABLISH_INDICATION);
        assertEquals(SDCCH, establish.channel());
        assertEquals(
                "0508", establish.value(RslElement.L3_INFORMATION).toString().substring(0, 4));
        assertEquals("west", terminal.mobile.cell());
    }

    @Test
    void anAnswerToAnotherRequestIsNotTaken() throws ProtocolViolation {
        TownScene scene = new TownScene();
        scene.network.place("5550100", new TownPlace(500, 0));
        TownScene.Terminal terminal = scene.new Terminal("5550100");
        terminal.register();
        RequestReference reference = scene.west.expectAccess();
        scene.west.activate(SDCCH, 0, Optional.empty());
        scene.west.grant(SDCCH, new RequestReference(reference.access() ^ 1, reference.frame()));

        scene.west.expectNothing();
        scene.west.expectAccess();
        assertEquals(MobileRadioState.ACCESS, terminal.mobile.state());
    }

    @Test
    void speechOverIpv6IsRefusedAndTheLinkGoesOn() {
        TownScene scene = new TownScene();
        scene.west.activate(TownScene.TCH, 1, Optional.empty());
        scene.west.speechHost = "0:0:0:0:0:0:0:1";
        scene.west.down(RslPdu.of(RslType.CREATE_CONNECTION, TownScene.TCH)
                .with(RslElement.SPEECH_MODE, 0x10)
                .with(RslElement.RTP_PAYLOAD, 3));

        scene.west.expect(RslType.CREATE_CONNECTION_NEGATIVE_ACKNOWLEDGE);
        assertNull(scene.west.speech, "the socket is closed");
    }

    @Test
    void afterMaxRetransTheTerminalIsReleased() {
        TownScene scene = new TownScene();
        scene.network.place("5550100", new TownPlace(500, 0));
        TownScene.Terminal terminal = scene.new Terminal("5550100");
        terminal.register();
        scene.pass(30 * SECOND);

        assertEquals(8, scene.west.up.size(), "the first request and seven more");
        assertEquals("060d01", terminal.expectLayer3());
        assertEquals(MobileRadioState.IDLE, terminal.mobile.state());
    }

    @Test
    void aRefusedMobileAsksAgainAfterT3122() throws ProtocolViolation {
        TownScene scene = new TownScene();
        scene.network.place("5550100", new TownPlace(500, 0));
        scene.new Terminal("5550100").register();
        RequestReference reference = scene.west.expectAccess();
        long refused = scene.now;
        scene.west.down(RslPdu.of(RslType.IMMEDIATE_ASSIGN_COMMAND, ChannelNumber.of(Kind.PCH_AGCH, 0))
                .with(RslElement.FULL_IMMEDIATE_ASSIGN, new ImmediateAssignmentReject(List.of(reference), 5).encode()));

        scene.west.expectAccess();
        assertTrue(scene.now - refused >= 5 * SECOND, (scene.now - refused) + " ns");
    }

    @ParameterizedTest
    @ValueSource(strings = {"east", ""})
    void aGrantCountsAtTheTowerThatWasAskedWhateverCellIdleModeHasChosenSince(String chosen) throws ProtocolViolation {
        TownScene scene = new TownScene();
        scene.network.place("5550100", new TownPlace(500, 0));
        TownScene.Terminal terminal = scene.new Terminal("5550100");
        terminal.register();
        RequestReference refused = scene.west.expectAccess();
        scene.west.down(RslPdu.of(RslType.IMMEDIATE_ASSIGN_COMMAND, ChannelNumber.of(Kind.PCH_AGCH, 0))
                .with(RslElement.FULL_IMMEDIATE_ASSIGN, new ImmediateAssignmentReject(List.of(refused), 20).encode()));
        if (chosen.isEmpty()) {
            scene.network.place("5550100", new TownPlace(200_000, 0));
        } else {
            scene.network.place("5550100", new TownPlace(3_500, 0));
        }
        RequestReference reference = scene.west.expectAccess();
        assertEquals(chosen, terminal.mobile.cell());
        scene.network.place("5550100", new TownPlace(500, 0));
        scene.east.activate(SDCCH, 0, Optional.empty());
        scene.west.activate(SDCCH, 0, Optional.empty());
        scene.west.grant(SDCCH, reference);

        assertEquals(SDCCH, scene.west.expect(RslType.ESTABLISH_INDICATION).channel());
        scene.east.expectNothing();
        assertEquals("west", terminal.mobile.cell());
    }

    @ParameterizedTest
    @ValueSource(strings = {"MOBILE_ORIGINATED_CALL 7", "SHORT_MESSAGE 1"})
    void theCauseOfAChannelRequestTellsTheService(String row) throws ProtocolViolation {
        String[] words = row.split(" ");
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.onSignallingChannel();
        terminal.leave();
        scene.west.up.clear();
        terminal.send(true, new CmServiceRequest(ServiceType.valueOf(words[0]), 7, terminal.imsi));

        int access = scene.west.expectAccess().access();
        assertEquals(Integer.parseInt(words[1]), words[1].equals("7") ? access >> 5 : access >> 4);
    }

    @Test
    void onlyThePagedMobileAnswersAndOnlyInItsGroup() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.onSignallingChannel();
        Tmsi tmsi = new Tmsi(0x12345678);
        scene.west.down(SDCCH, new LocationUpdatingAccept(LocationArea.TEST, Optional.of(tmsi)));
        terminal.expectLayer3();
        terminal.leave();
        // Two blocks in each of two multiframes; 001015550100 has the last digits 100.
        for (int group = 0; group < 4; group++) {
            page(scene, group, tmsi);
            page(scene, group, new Tmsi(0x12345679));
        }
        scene.pass(2 * SECOND);

        assertEquals(new RslMessage.PagingCommand(tmsi), terminal.down.poll());
        terminal.expectNothing();
        terminal.send(true, new PagingResponse(7, tmsi));
        scene.west.discardReports();
        scene.west.up.clear();
        assertEquals(4, scene.west.expectAccess().access() >> 5, "answer to paging has cause 100x");
    }

    private static void page(TownScene scene, int group, Tmsi tmsi) {
        scene.west.down(RslPdu.of(RslType.PAGING_COMMAND, ChannelNumber.of(Kind.PCH_AGCH, 0))
                .with(RslElement.PAGING_GROUP, group)
                .with(RslElement.MOBILE_IDENTITY, OctetString.ofHex("f4" + String.format("%08x", tmsi.value()))));
    }

    @Test
    void layer3WaitsUntilTheAssignmentIsComplete() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.onSignallingChannel();
        scene.west.activate(TCH, 1, Optional.empty());
        scene.west.down(
                SDCCH,
                new simgsm.air.RadioResource.AssignmentCommand(new simgsm.air.ChannelDescription(TCH, 2, 100), 5, 1));
        terminal.send(false, new TmsiReallocationComplete());
        scene.west.expectNothing();

        scene.pass(39 * MILLI);
        scene.west.discardReports();
        scene.west.expectNothing();
        scene.pass(2 * MILLI);
        scene.west.discardReports();
        RslPdu establish = scene.west.expect(RslType.ESTABLISH_INDICATION);
        assertEquals(TCH, establish.channel());
        assertFalse(establish.has(RslElement.L3_INFORMATION));
        assertEquals("062900", scene.west.expectLayer3());
        assertEquals("051b", scene.west.expectLayer3());
        terminal.expectNothing();
    }

    @Test
    void anAssignmentToAChannelThatIsNotActiveFailsOnTheOldOne() throws ProtocolViolation {
        TownScene scene = new TownScene();
        scene.onSignallingChannel();
        scene.west.down(
                SDCCH,
                new simgsm.air.RadioResource.AssignmentCommand(new simgsm.air.ChannelDescription(TCH, 2, 100), 5, 1));
        scene.pass(100 * MILLI);

        scene.west.discardReports();
        assertEquals("062f6f", scene.west.expectLayer3());
    }

    @Test
    void aReportComesEvery480MillisecondsWithTheNeighbours() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        scene.west.up.clear();
        scene.network.place("5550100", new TownPlace(1_000, 0));
        scene.pass(480 * MILLI * 5);

        assertEquals(5, scene.west.up.size());
        RslPdu last = null;
        for (int i = 0; i < 5; i++) {
            last = scene.west.expect(RslType.MEASUREMENT_RESULT);
            assertEquals(i, last.octet(RslElement.MEASUREMENT_RESULT_NUMBER));
        }
        MeasurementResults results = ((MeasurementReport)
                        Layer3Codec.decode(last.value(RslElement.L3_INFORMATION).toArray(), Direction.UPLINK))
                .results();
        // Hata at 955 MHz: 127.1 dB at 1 km, so -84.1 dBm of 43 dBm, which is RXLEV 26.
        assertEquals(26, results.fullLevel());
        assertEquals(List.of(new MeasurementResults.Neighbour(10, 1, 11)), results.neighbours());
        assertEquals(2, last.value(RslElement.L1_INFORMATION).octet(1), "1 000 m are two steps of 553.5 m");
        terminal.expectNothing();
    }

    @Test
    void aHandoverGoesByAccessPhysicalInformationAndComplete() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        scene.network.place("5550100", new TownPlace(2_200, 0));
        scene.pass(480 * MILLI);
        scene.east.activate(TCH, 2, Optional.of(77));
        scene.commandHandover(77);
        terminal.send(false, new TmsiReallocationComplete());
        scene.west.discardReports();
        scene.west.expectNothing();
        scene.pass(21 * MILLI);
        assertEquals(3, scene.east.expect(RslType.HANDOVER_DETECTION).octet(RslElement.ACCESS_DELAY), "1 800 m");
        scene.pass(100 * MILLI);

        scene.east.discardReports();
        RslPdu establish = scene.east.expect(RslType.ESTABLISH_INDICATION);
        assertFalse(establish.has(RslElement.L3_INFORMATION));
        assertEquals("062c00", scene.east.expectLayer3());
        assertEquals("051b", scene.east.expectLayer3());
        assertEquals("east", terminal.mobile.cell());
        assertTrue(scene.events.contains(
                new MobileEvent.HandedOver(terminal.mobile, "west", "east", MobileEvent.HandoverResult.SUCCESS, 0)));
        terminal.expectNothing();
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aHandoverThatIsNotAnsweredReturnsToTheOldChannelAfterT3124(boolean isActive) throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        if (isActive) {
            scene.east.activate(TCH, 2, Optional.of(78));
        }
        scene.commandHandover(77);
        scene.pass(319 * MILLI);
        scene.west.discardReports();
        scene.west.expectNothing();
        scene.pass(2 * MILLI);

        scene.west.discardReports();
        assertEquals(TCH, scene.west.expect(RslType.ESTABLISH_INDICATION).channel());
        assertEquals("062803", scene.west.expectLayer3());
        assertEquals("west", terminal.mobile.cell());
        assertEquals(MobileRadioState.DEDICATED, terminal.mobile.state());
        scene.east.expectNothing();
    }

    @Test
    void aSynchronisedHandoverNeedsNoPhysicalInformation() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        scene.network.place("5550100", new TownPlace(2_200, 0));
        scene.pass(480 * MILLI);
        scene.east.activate(TCH, 3, Optional.of(77));
        scene.commandHandover(77);
        scene.pass(200 * MILLI);

        scene.east.discardReports();
        scene.east.expect(RslType.HANDOVER_DETECTION);
        scene.east.expect(RslType.ESTABLISH_INDICATION);
        assertEquals("062c00", scene.east.expectLayer3());
        assertEquals("east", terminal.mobile.cell());
    }

    @Test
    void theSpeechGapOfAHandoverIsWhatTheTerminalDidNotHear() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        scene.network.place("5550100", new TownPlace(2_200, 0));
        scene.pass(480 * MILLI);
        scene.east.activate(TCH, 2, Optional.of(77));
        scene.connectSpeech(scene.east, TCH);
        for (int i = 0; i < 50; i++) {
            scene.pass(20 * MILLI);
            if (i == 25) {
                scene.commandHandover(77);
            }
            scene.west.speech.accept(speech(i));
            scene.east.speech.accept(speech(i));
        }

        long longest = 0;
        for (int i = 1; i < terminal.heardNanos.size(); i++) {
            longest = Math.max(longest, terminal.heardNanos.get(i) - terminal.heardNanos.get(i - 1));
        }
        int gap = (int) (longest / MILLI) - 20;
        assertTrue(gap > 0 && gap <= 200, gap + " ms");
        assertTrue(scene.events.contains(new MobileEvent.SpeechGap(terminal.mobile, gap)));
        assertEquals(50 - gap / 20, terminal.heardNanos.size());
    }

    @Test
    void aFrameThatWasHeardInTheOldCellIsNotHeardAgainInTheNewOne() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        scene.network.place("5550100", new TownPlace(2_200, 0));
        scene.pass(480 * MILLI);
        scene.east.activate(TCH, 2, Optional.of(77));
        scene.connectSpeech(scene.east, TCH);
        scene.west.speech.accept(speech(0xffff));
        scene.commandHandover(77);
        scene.pass(200 * MILLI);
        assertEquals("east", terminal.mobile.cell());

        scene.east.speech.accept(speech(0xfffe));
        scene.east.speech.accept(speech(0xffff));
        assertEquals(1, terminal.heardNanos.size());
        scene.east.speech.accept(speech(3));

        assertEquals(2, terminal.heardNanos.size());
        assertTrue(scene.events.contains(new MobileEvent.SpeechGap(terminal.mobile, 60)));
    }

    private static byte[] speech(int number) {
        byte[] frame = new byte[33];
        frame[0] = (byte) 0xd0;
        return new RtpPacket(RtpPacket.GSM_FULL_RATE, number, number * 160L, 1, frame).encode();
    }

    @Test
    void aLawOfATerminalGoesOutAsGsm() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        terminal.mobile.speechArrived(new RtpPacket(RtpPacket.A_LAW, 9, 1_440, 1, new byte[160]).encode());

        RtpPacket sent = RtpPacket.decode(scene.west.spoken.get(0));
        assertEquals(RtpPacket.GSM_FULL_RATE, sent.payloadType());
        assertEquals(9, sent.sequence());
    }

    @Test
    void aTowerThatFailsIsNoticedAfterTheRadioLinkTimeOutAndAnotherCellIsChosen() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        scene.network.switchTower(scene.west.tower, false);
        scene.pass(480 * MILLI * (TownScene.LINK_TIMEOUT - 1));
        terminal.expectNothing();
        scene.pass(480 * MILLI);

        assertEquals("060d01", terminal.expectLayer3());
        assertTrue(scene.events.contains(new MobileEvent.RadioLinkFailed(terminal.mobile)));
        scene.pass(480 * MILLI);
        assertEquals("east", terminal.mobile.cell());
    }

    @Test
    void aMobileThatLeavesTheCoverageLosesItsLinkAndTheTowerReportsIt() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        scene.west.up.clear();
        scene.network.place("5550100", new TownPlace(-60_000, 0));
        scene.pass(480 * MILLI * (TownScene.LINK_TIMEOUT + 1));

        scene.west.discardReports();
        scene.west.expect(RslType.CONNECTION_FAILURE);
        assertEquals("060d01", terminal.expectLayer3());
        assertEquals(MobileRadioState.IDLE, terminal.mobile.state());
    }

    @Test
    void withTheControllerOfTheLastTowerEachTerminalIsLetGoAndGoesOnWalkingWhenItIsBack() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        scene.network.walk("5550100", List.of(new TownPlace(1_000, 0)), 10);
        scene.pass(10 * SECOND);
        TownPlace place = terminal.mobile.walker().place();
        scene.west.drop("the centre is killed");
        assertEquals(List.of(), terminal.closed, "the other tower is in service");
        scene.east.drop("the centre is killed");
        assertEquals(List.of("no tower has a controller"), terminal.closed);
        assertEquals(List.of(), scene.network.mobiles());

        TownScene.Terminal again = scene.new Terminal("5550100");
        again.register();
        assertEquals("060d01", again.expectLayer3(), "there is no network");
        scene.east.connect(1);
        scene.west.connect(1);
        scene.pass(480 * MILLI);
        assertEquals("west", again.mobile.cell());
        again.register();
        assertEquals(0, place.distanceMetres(again.mobile.walker().place()), 10);
        assertEquals(List.of(new TownPlace(1_000, 0)), again.mobile.walker().ahead());
        scene.west.up.clear();
        scene.west.expectAccess();
        assertEquals(List.of(), again.closed);
    }

    @Test
    void towersThatAreSwitchedOffLeaveTheTerminalsConnected() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        scene.network.switchTower(scene.west.tower, false);
        scene.network.switchTower(scene.east.tower, false);
        scene.pass(10 * SECOND);
        assertEquals(List.of(), terminal.closed);
    }

    @Test
    void aTerminalThatIsGoneIsReportedAtOnce() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        scene.west.up.clear();
        scene.network.disconnected(terminal.mobile);

        scene.west.expect(RslType.CONNECTION_FAILURE);
        scene.pass(10 * SECOND);
        scene.west.expectNothing();
    }

    @Test
    void aReleasedChannelIsFreeAgain() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.onSignallingChannel();
        scene.west.down(SDCCH, new ChannelRelease(0));
        assertEquals("060d00", terminal.expectLayer3());
        terminal.leave();
        scene.west.expect(RslType.RELEASE_INDICATION);
        scene.west.down(RslPdu.of(RslType.RELEASE_REQUEST, SDCCH, 0).with(RslElement.RELEASE_MODE, 1));
        scene.west.expect(RslType.RELEASE_CONFIRM);
        scene.west.down(RslPdu.of(RslType.RF_CHANNEL_RELEASE, SDCCH));
        scene.west.expect(RslType.RF_CHANNEL_RELEASE_ACKNOWLEDGE);
        scene.west.activate(SDCCH, 0, Optional.empty());
    }

    @Test
    void aChannelThatIsActiveAlreadyIsRefused() throws ProtocolViolation {
        TownScene scene = new TownScene();
        scene.onSignallingChannel();
        scene.west.down(RslPdu.of(RslType.CHANNEL_ACTIVATION, SDCCH)
                .with(RslElement.ACTIVATION_TYPE, 0)
                .with(RslElement.CHANNEL_MODE, 0, 3, 1, 0));
        scene.west.expect(RslType.CHANNEL_ACTIVATION_NEGATIVE_ACKNOWLEDGE);
    }

    @Test
    void shortMessagesHaveALinkOfTheirOwn() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.onSignallingChannel();
        scene.west.down(RslPdu.of(RslType.ESTABLISH_REQUEST, SDCCH, 3));
        assertEquals(3, scene.west.expect(RslType.ESTABLISH_CONFIRM).sapi());
        scene.west.down(
                RslPdu.of(RslType.DATA_REQUEST, SDCCH, 3).with(RslElement.L3_INFORMATION, OctetString.ofHex("0904")));
        assertEquals(
                new RslMessage.DataRequest(RslMessage.Sapi.SHORT_MESSAGES, OctetString.ofHex("0904")),
                terminal.down.poll());
        terminal.mobile.arrived(
                new RslMessage.DataIndication(RslMessage.Sapi.SHORT_MESSAGES, OctetString.ofHex("8904")));
        assertEquals(3, scene.west.expect(RslType.DATA_INDICATION).sapi());
    }

    @Test
    void theFirstShortMessageOfAMobileEstablishesItsLink() throws ProtocolViolation {
        TownScene scene = new TownScene();
        TownScene.Terminal terminal = scene.inCall();
        terminal.mobile.arrived(
                new RslMessage.DataIndication(RslMessage.Sapi.SHORT_MESSAGES, OctetString.ofHex("8904")));
        RslPdu establish = scene.west.expect(RslType.ESTABLISH_INDICATION);
        assertEquals(0x43, establish.octet(RslElement.LINK_IDENTIFIER), "beside speech on the SACCH");
        scene.west.expect(RslType.DATA_INDICATION);
    }

    @Test
    void twoRunsOfOneSeedAreAlike() throws ProtocolViolation {
        Set<String> runs = new HashSet<>();
        for (int run = 0; run < 2; run++) {
            TownScene scene = new TownScene();
            TownScene.Terminal terminal = scene.inCall();
            scene.network.walk("5550100", List.of(new TownPlace(9_000, 0)), 300);
            scene.pass(40 * SECOND);
            StringBuilder text = new StringBuilder();
            scene.events.forEach(event -> text.append(event.toString().replaceAll("@[0-9a-f]+", "")));
            scene.west.up.forEach(message -> text.append(message));
            text.append(terminal.mobile.state());
            runs.add(text.toString());
        }
        assertEquals(1, runs.size());
    }

    @Test
    void withoutACellARegistrationWaitsAndACallFails() {
        TownScene scene = new TownScene();
        scene.network.place("5550100", new TownPlace(-60_000, 0));
        TownScene.Terminal terminal = scene.new Terminal("5550100");
        terminal.register();
        scene.pass(10 * SECOND);
        assertEquals(IdleSelection.NONE, terminal.mobile.serving());
        terminal.expectNothing();

        terminal.send(true, new CmServiceRequest(ServiceType.MOBILE_ORIGINATED_CALL, 7, terminal.imsi));
        assertEquals("060d01", terminal.expectLayer3());
    }
}
