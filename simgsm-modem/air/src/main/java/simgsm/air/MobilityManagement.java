package simgsm.air;

import java.util.Optional;
import simgsm.octets.OctetString;

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

    /** No ciphering key is stored. */
    int NO_KEY = 7;

    private static void checkLength(String what, OctetString octets, int least, int most) {
        if (octets.length() < least || octets.length() > most) {
            throw new IllegalArgumentException(
                    what + " has " + octets.length() + " octets, " + least + " to " + most + " were expected");
        }
    }

    /** @param keySequence ciphering key sequence number, 0 to 6, or 7 for no key */
    record LocationUpdatingRequest(
            LocationUpdatingType updatingType, int keySequence, LocationArea oldArea, MobileIdentity identity)
            implements MobilityManagement {
        public LocationUpdatingRequest {
            KeySequence.check(keySequence);
        }
    }

    record LocationUpdatingAccept(LocationArea area, Optional<MobileIdentity> newIdentity)
            implements MobilityManagement {}

    record LocationUpdatingReject(RejectCause cause) implements MobilityManagement {}

    record IdentityRequest(MobileIdentity.Type identityType) implements MobilityManagement {}

    record IdentityResponse(MobileIdentity identity) implements MobilityManagement {}

    /** RAND (16 octets) and, for a USIM, AUTN (16 octets). */
    record AuthenticationRequest(int keySequence, OctetString rand, Optional<OctetString> autn)
            implements MobilityManagement {
        public static final int RAND_LENGTH = 16;
        public static final int AUTN_LENGTH = 16;

        public AuthenticationRequest {
            KeySequence.check(keySequence);
            checkLength("RAND", rand, RAND_LENGTH, RAND_LENGTH);
            autn.ifPresent(octets -> checkLength("AUTN", octets, AUTN_LENGTH, AUTN_LENGTH));
        }
    }

    /** SRES (4 octets), or RES (4 to 16 octets, the rest after the first four in the extension). */
    record AuthenticationResponse(OctetString response) implements MobilityManagement {
        public static final int MIN_LENGTH = 4;
        public static final int MAX_LENGTH = 16;

        public AuthenticationResponse {
            checkLength("RES", response, MIN_LENGTH, MAX_LENGTH);
        }
    }

    record AuthenticationReject() implements MobilityManagement {}

    record AuthenticationFailure(RejectCause cause, Optional<OctetString> auts) implements MobilityManagement {
        public static final int AUTS_LENGTH = 14;

        public AuthenticationFailure {
            auts.ifPresent(octets -> checkLength("AUTS", octets, AUTS_LENGTH, AUTS_LENGTH));
        }
    }

    record TmsiReallocationComplete() implements MobilityManagement {}

    /** @param networkName as it would stand on the phone's display, at most 64 characters */
    record MmInformation(String networkName) implements MobilityManagement {
        public static final int MAX_NAME_LENGTH = 64;

        public MmInformation {
            if (networkName.length() > MAX_NAME_LENGTH) {
                throw new IllegalArgumentException(
                        "a network name of " + networkName.length() + " characters, at most " + MAX_NAME_LENGTH);
            }
        }
    }

    record CmServiceRequest(ServiceType service, int keySequence, MobileIdentity identity)
            implements MobilityManagement {
        public CmServiceRequest {
            KeySequence.check(keySequence);
        }
    }

    record CmServiceAccept() implements MobilityManagement {}

    record CmServiceReject(RejectCause cause) implements MobilityManagement {}

    /** The mobile no longer wants what it has asked for, and the radio connection neither. */
    record CmServiceAbort() implements MobilityManagement {}

    record ImsiDetachIndication(MobileIdentity identity) implements MobilityManagement {}

    record MmStatus(RejectCause cause) implements MobilityManagement {}
}
