package simgsm.air;

import java.util.Optional;

/** Mobility management messages (TS 24.008, 9.2), protocol discriminator 5. */
public sealed interface MobilityManagement extends Layer3Message {

    /** What a LOCATION UPDATING REQUEST is for (TS 24.008, 10.5.3.5). */
    enum LocationUpdatingType {
        NORMAL,
        PERIODIC,
        IMSI_ATTACH
    }

    /** What a CM SERVICE REQUEST asks for (TS 24.008, 10.5.3.3). */
    enum ServiceType {
        MOBILE_ORIGINATED_CALL(1),
        EMERGENCY_CALL(2),
        SHORT_MESSAGE(4),
        SUPPLEMENTARY_SERVICE(8);

        private final int code;

        ServiceType(int code) {
            this.code = code;
        }

        public int code() {
            return code;
        }
    }

    /** @param keySequence ciphering key sequence number, 0 to 6, or 7 for no key */
    record LocationUpdatingRequest(
            LocationUpdatingType updatingType, int keySequence, LocationArea oldArea, MobileIdentity identity)
            implements MobilityManagement {}

    record LocationUpdatingAccept(LocationArea area, Optional<MobileIdentity> newIdentity)
            implements MobilityManagement {}

    record LocationUpdatingReject(RejectCause cause) implements MobilityManagement {}

    record IdentityRequest(MobileIdentity.Type identityType) implements MobilityManagement {}

    record IdentityResponse(MobileIdentity identity) implements MobilityManagement {}

    /** The octets of RAND (16) and, for a USIM, AUTN (16) or an empty string. */
    record AuthenticationRequest(int keySequence, OctetString rand, Optional<OctetString> autn)
            implements MobilityManagement {}

    /** SRES (4 octets), or RES (4 to 16 octets, the rest after the first four in the extension). */
    record AuthenticationResponse(OctetString response) implements MobilityManagement {}

    record AuthenticationReject() implements MobilityManagement {}

    record AuthenticationFailure(RejectCause cause, Optional<OctetString> auts) implements MobilityManagement {}

    record TmsiReallocationComplete() implements MobilityManagement {}

    /** The network's name as it would stand on the phone's display. */
    record MmInformation(String networkName) implements MobilityManagement {}

    record CmServiceRequest(ServiceType service, int keySequence, MobileIdentity identity)
            implements MobilityManagement {}

    record CmServiceAccept() implements MobilityManagement {}

    record CmServiceReject(RejectCause cause) implements MobilityManagement {}

    record ImsiDetachIndication(MobileIdentity identity) implements MobilityManagement {}

    record MmStatus(RejectCause cause) implements MobilityManagement {}
}
