package simgsm.cells.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.cells.network.TownScene.MILLI;
import static simgsm.cells.network.TownScene.SDCCH;
import static simgsm.cells.network.TownScene.TCH;

import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.CipherAlgorithm;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.air.RadioResource.CipheringModeComplete;
import simgsm.air.RadioResource.ClassmarkChange;
import simgsm.cells.mobile.Mobile;
import simgsm.cells.mobile.MobileEvent;
import simgsm.octets.OctetString;
import simgsm.rr.RequestReference;

/** Ciphering at the towers (TS 48.058, 4.6 and 7), and the messages that a tower does not know. */
class AirCipheringTest {
    private static final String KC = "eae4be823af9a08b";

    private final TownScene scene = new TownScene();
    private TownScene.Terminal terminal;

    @BeforeEach
    void connect() throws ProtocolViolation {
        terminal = scene.onSignallingChannel();
    }

    private void command(String information) {
        scene.west.down(RslPdu.of(RslType.ENCRYPTION_COMMAND, SDCCH)
                .with(RslElement.ENCRYPTION_INFORMATION, OctetString.ofHex(information))
                .with(RslElement.LINK_IDENTIFIER, 0)
                .with(RslElement.L3_INFORMATION, OctetString.ofHex("063501")));
    }

    private boolean isCiphered() {
        return terminal.mobile.channel().orElseThrow().isCiphered();
    }

    @Test
    void theMobileCiphersWithItsAnswerToTheCommand() throws ProtocolViolation {
        command("02" + KC);
        assertEquals("063501", terminal.expectLayer3());
        assertFalse(isCiphered());
        terminal.cipher("02" + KC);
        assertEquals("0632", scene.west.expectLayer3());
        assertTrue(isCiphered());
        assertTrue(scene.events.stream()
                .anyMatch(event -> event instanceof MobileEvent.Ciphered ciphered
                        && ciphered.algorithm().title().equals("a5/1")));
    }

    /** SRES was right, as of COMP128 version 2 in place of 3. */
    @Test
    void aTowerCannotReadAMobileWithAnotherKeySoThatTheLinkFails() throws ProtocolViolation {
        command("02" + KC);
        terminal.expectLayer3();
        terminal.cipher("02eae4be823af9a000");
        assertTrue(scene.events.contains(new MobileEvent.CipherMismatched(terminal.mobile, CipherAlgorithm.A5_1)));
        scene.west.expectNothing();
        scene.west.down(SDCCH, new RadioResource.ChannelRelease(0));
        terminal.expectNothing();
        scene.pass((TownScene.LINK_TIMEOUT + 1) * Mobile.PERIOD_NANOS);
        scene.west.discardReports();
        scene.west.expect(RslType.CONNECTION_FAILURE);
        assertTrue(scene.events.contains(new MobileEvent.RadioLinkFailed(terminal.mobile)));
        assertFalse(scene.events.stream().anyMatch(MobileEvent.Ciphered.class::isInstance));
        assertEquals("060d01", terminal.expectLayer3());
    }

    /** The next connection begins in the clear. */
    @Test
    void aKeyIsForgottenWithItsChannel() throws ProtocolViolation {
        command("02" + KC);
        terminal.expectLayer3();
        terminal.cipher("02" + KC);
        scene.west.expectLayer3();
        terminal.leave();
        scene.west.expect(RslType.RELEASE_INDICATION);
        scene.west.down(RslPdu.of(RslType.RF_CHANNEL_RELEASE, SDCCH));
        scene.west.expect(RslType.RF_CHANNEL_RELEASE_ACKNOWLEDGE);
        terminal.register();
        RequestReference reference = scene.west.expectAccess();
        scene.west.activate(SDCCH, 0, Optional.empty());
        scene.west.grant(SDCCH, reference);
        scene.west.expect(RslType.ESTABLISH_INDICATION);
        terminal.send(false, new ClassmarkChange());
        assertEquals("0616033319802003601400", scene.west.expectLayer3());
    }

    /** Until the answer to A5/0 the mobile still ciphers. */
    @Test
    void cipheringEndsWithTheAnswerToA5_0() throws ProtocolViolation {
        command("02" + KC);
        terminal.expectLayer3();
        terminal.cipher("02" + KC);
        scene.west.expectLayer3();
        command("01");
        assertEquals("063501", terminal.expectLayer3());
        terminal.cipher("01");
        assertEquals("0632", scene.west.expectLayer3());
        assertFalse(isCiphered());
    }

    @Test
    void anAnswerInTheClearIsNotRead() throws ProtocolViolation {
        command("02" + KC);
        terminal.expectLayer3();
        terminal.send(false, new CipheringModeComplete(Optional.empty()));
        scene.west.expectNothing();
        assertFalse(isCiphered());
    }

    /** A5/3 without --a5 0,1,3; A5/1 with a key of 7 octets; nothing. */
    @ParameterizedTest
    @CsvSource({"04eae4be823af9a08b, 40", "02eae4be823af9a0, 64", "'', 64"})
    void aCommandThatTheTowerCannotFollowIsReportedAndNotSent(String information, String cause) {
        command(information);
        RslPdu report = scene.west.expect(RslType.ERROR_REPORT);
        assertEquals(Optional.of(OctetString.ofHex(cause)), report.find(RslElement.CAUSE));
        assertEquals(Optional.of(OctetString.ofHex("26")), report.find(RslElement.MESSAGE_IDENTIFIER));
        terminal.expectNothing();
    }

    @Test
    void anUnknownTypeAndAMessageForAnInactiveChannelAreReported() {
        scene.west.down(RslPdu.of(RslType.RELEASE_CONFIRM, SDCCH));
        scene.west.expect(RslType.ERROR_REPORT);
        scene.west.down(RslPdu.of(RslType.DATA_REQUEST, TCH, 0));
        assertEquals(
                Optional.of(OctetString.ofHex("62")),
                scene.west.expect(RslType.ERROR_REPORT).find(RslElement.CAUSE));
        scene.west.down(RslPdu.of(RslType.ERROR_REPORT));
        scene.west.expectNothing();
    }

    /** The key in CHANNEL ACTIVATION, as a controller gives it for a handover. */
    @Test
    void aChannelActivatedWithAKeyIsCipheredFromItsFirstMessage() throws ProtocolViolation {
        scene.west.down(RslPdu.of(RslType.CHANNEL_ACTIVATION, TCH)
                .with(RslElement.ACTIVATION_TYPE, 1)
                .with(RslElement.ENCRYPTION_INFORMATION, OctetString.ofHex("02" + KC)));
        scene.west.expect(RslType.CHANNEL_ACTIVATION_ACKNOWLEDGE);
        assertTrue(scene.west.tower.channel(TCH).orElseThrow().isCiphered());
        scene.east.down(RslPdu.of(RslType.CHANNEL_ACTIVATION, TCH)
                .with(RslElement.ACTIVATION_TYPE, 1)
                .with(RslElement.ENCRYPTION_INFORMATION, OctetString.ofHex("04" + KC)));
        assertEquals(
                Optional.of(OctetString.ofHex("40")),
                scene.east
                        .expect(RslType.CHANNEL_ACTIVATION_NEGATIVE_ACKNOWLEDGE)
                        .find(RslElement.CAUSE));
    }

    /** The terminal has A5/1 and A5/3, its radio part only A5/1. */
    @Test
    void aClassmarkNamesWhatTheRadioPartCanCipherWith() throws ProtocolViolation {
        terminal.send(false, new ClassmarkChange());
        assertEquals("0616033319802003601400", scene.west.expectLayer3());
        scene.pass(MILLI);
    }
}
