package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.abis.RslMessage.EncryptionCommand;
import simgsm.air.CallControl.Setup;
import simgsm.air.CipherAlgorithm;
import simgsm.air.Imei;
import simgsm.air.Imeisv;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement.AuthenticationRequest;
import simgsm.air.MobilityManagement.AuthenticationResponse;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.IdentityRequest;
import simgsm.air.MobilityManagement.IdentityResponse;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.MobilityManagement.MmAbort;
import simgsm.air.MobilityManagement.TmsiReallocationCommand;
import simgsm.air.MobilityManagement.TmsiReallocationComplete;
import simgsm.air.Msisdn;
import simgsm.air.RadioResource.CipheringModeCommand;
import simgsm.air.RadioResource.CipheringModeComplete;
import simgsm.air.RadioResource.ClassmarkChange;
import simgsm.air.RadioResource.ClassmarkEnquiry;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.RadioResource.RrStatus;
import simgsm.air.RejectCause;
import simgsm.air.Tmsi;
import simgsm.octets.OctetString;
import simgsm.station.mobility.Sim;

/** Ciphering, capabilities and identities at the mobile (TS 44.018, 3.4.7 and 3.4.10; TS 24.008, 4.3.1 and 4.3.5). */
class CipheringTest {
    private static final OctetString KC = OctetString.ofHex("eae4be823af9a08b");
    private static final CipheringModeCommand A5_1 = new CipheringModeCommand(CipherAlgorithm.A5_1, 0);

    private final Scene scene =
            new Scene((rand, autn) -> Sim.AuthenticationResult.response(OctetString.ofHex("46f8416a"), KC));

    private void authenticate() {
        scene.linkUp();
        scene.identify();
        scene.expectFirst(LocationUpdatingRequest.class);
        scene.down(
                new AuthenticationRequest(2, OctetString.ofHex("23553cbe9637a89d218ae64dae47bf35"), Optional.empty()));
        scene.expect(AuthenticationResponse.class);
    }

    /** The key for the towers comes before the answer that they read with it. @param information TS 48.058, 9.3.7 */
    private void expectCiphered(String information, Optional<MobileIdentity> equipment) {
        EncryptionCommand key = assertInstanceOf(EncryptionCommand.class, scene.up.poll());
        assertEquals(OctetString.ofHex(information), key.information());
        scene.expect(new CipheringModeComplete(equipment));
    }

    private Imeisv equipment() {
        return Imeisv.of(new Imei(scene.identity.imei().digits()));
    }

    @Test
    void aStationWithAKeyCompletesCipheringAndNamesItsEquipmentWhenAsked() {
        authenticate();
        scene.down(new CipheringModeCommand(CipherAlgorithm.A5_1, 1));
        expectCiphered("02" + KC, Optional.of(equipment()));
        scene.down(A5_1);
        scene.expect(new RrStatus(111));
        scene.down(new CipheringModeCommand(CipherAlgorithm.A5_0, 0));
        expectCiphered("01", Optional.empty());
    }

    @Test
    void cipheringEndsWithTheChannelAndTheKeyStays() {
        authenticate();
        scene.down(A5_1);
        expectCiphered("02" + KC, Optional.empty());
        scene.grantLocationUpdating();
        scene.releaseChannel();
        scene.page(Scene.TMSI);
        assertEquals(2, scene.expectFirst(PagingResponse.class).keySequence());
        scene.down(A5_1);
        expectCiphered("02" + KC, Optional.empty());
    }

    @Test
    void cipheringAcceptsARequestedService() {
        authenticate();
        scene.grantLocationUpdating();
        scene.releaseChannel();
        scene.station.dial(new Msisdn("5550200"));
        scene.expectFirst(CmServiceRequest.class);
        scene.down(A5_1);
        expectCiphered("02" + KC, Optional.empty());
        scene.expect(Setup.class);
    }

    @Test
    void withoutAKeyOrWithA5_2CipheringIsRefused() {
        Scene open = Scene.registered();
        open.page(Scene.TMSI);
        open.expectFirst(PagingResponse.class);
        open.down(A5_1);
        open.expect(new RrStatus(111));
        authenticate();
        scene.down(new CipheringModeCommand(CipherAlgorithm.A5_2, 0));
        scene.expect(new RrStatus(111));
    }

    @Test
    void capabilitiesAndSoftwareVersionAreToldWhenAsked() {
        authenticate();
        scene.down(new ClassmarkEnquiry());
        scene.expect(new ClassmarkChange());
        scene.down(new IdentityRequest(MobileIdentity.Type.IMEISV));
        scene.expect(new IdentityResponse(equipment()));
    }

    /** A handover without towers, an algorithm without a name, and a type without a message. */
    @ParameterizedTest
    @ValueSource(strings = {"062b0b6e09606e010e", "062d00", "0634", "06ff"})
    void anUnknownMessageOfRadioResourcesIsAnswered(String hex) {
        authenticate();
        scene.downHex(hex);
        scene.expect(new RrStatus(97));
    }

    @Test
    void aNewTemporaryIdentityIsConfirmedAndUsed() {
        authenticate();
        scene.grantLocationUpdating();
        scene.down(new TmsiReallocationCommand(LocationArea.TEST, new Tmsi(0x12345678)));
        scene.expect(TmsiReallocationComplete.class);
        scene.down(new TmsiReallocationCommand(LocationArea.TEST, scene.identity.imsi()));
        scene.expect(TmsiReallocationComplete.class);
        scene.releaseChannel();
        scene.page(new Tmsi(0x12345678));
        scene.expectNothing();
        scene.page(scene.identity.imsi());
        assertEquals(
                scene.identity.imsi(), scene.expectFirst(PagingResponse.class).identity());
    }

    @Test
    void anAbortEndsTheConnectionsAndAnIllegalEquipmentItsService() {
        authenticate();
        scene.grantLocationUpdating();
        scene.releaseChannel();
        scene.reported.clear();
        scene.station.dial(new Msisdn("5550200"));
        scene.expectFirst(CmServiceRequest.class);
        scene.down(new MmAbort(RejectCause.NETWORK_FAILURE));
        scene.expectNothing();
        scene.releaseChannel();
        assertEquals(List.of("calling 5550200", "released 38"), scene.reported.lines());
        assertEquals(true, scene.station.snapshot().registered());
        scene.page(Scene.TMSI);
        scene.expectFirst(PagingResponse.class);
        scene.down(new MmAbort(RejectCause.ILLEGAL_ME));
        assertEquals(
                Optional.of(RejectCause.ILLEGAL_ME), scene.station.snapshot().rejectCause());
        assertEquals(List.of(), List.copyOf(scene.up));
    }
}
