package simgsm.air;

import java.time.OffsetDateTime;
import java.util.Optional;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.octets.Octets;

/** Mobility management messages (TS 24.008, 9.2), protocol discriminator 5. */
public sealed interface MobilityManagement extends Layer3Message {
    /** The purpose of a LOCATION UPDATING REQUEST (TS 24.008, 10.5.3.5). */
    enum LocationUpdatingType implements Coded {
        NORMAL,
        PERIODIC,
        IMSI_ATTACH;

        @Override
        public int code() {
            return ordinal();
        }
    }

    /** The service requested by a CM SERVICE REQUEST (TS 24.008, 10.5.3.3). */
    enum ServiceType implements Coded {
        MOBILE_ORIGINATED_CALL(1),
        EMERGENCY_CALL(2),
        SHORT_MESSAGE(4),
        SUPPLEMENTARY_SERVICE(8);

        private final int code;

        ServiceType(int code) {
            this.code = code;
        }

        @Override
        public int code() {
            return code;
        }
    }

    /** Ciphering key sequence number (10.5.1.2) when no key is stored; 0 to 6 otherwise. */
    int NO_KEY = 7;

    /** @param keySequence ciphering key sequence number, 0 to 6, or 7 for no key */
    record LocationUpdatingRequest(
            LocationUpdatingType updatingType, int keySequence, LocationArea oldArea, MobileIdentity identity)
            implements MobilityManagement {}

    record LocationUpdatingAccept(LocationArea area, Optional<MobileIdentity> newIdentity)
            implements MobilityManagement {}

    record LocationUpdatingReject(RejectCause cause) implements MobilityManagement {}

    record IdentityRequest(MobileIdentity.Type identityType) implements MobilityManagement {}

    record IdentityResponse(MobileIdentity identity) implements MobilityManagement {}

    /** @param rand 16 octets; @param autn 16 octets, for a USIM only */
    record AuthenticationRequest(int keySequence, OctetString rand, Optional<OctetString> autn)
            implements MobilityManagement {}

    /** @param sres SRES, or the first 4 octets of RES; @param extension the other octets of RES, at most 12 */
    record AuthenticationResponse(OctetString sres, Optional<OctetString> extension) implements MobilityManagement {
        private static final int SRES_LENGTH = 4;

        /** @param response SRES of 4 octets or RES of 4 to 16 */
        public AuthenticationResponse(OctetString response) {
            this(
                    part(response, 0, Math.min(SRES_LENGTH, response.length())),
                    Optional.of(response)
                            .filter(octets -> octets.length() > SRES_LENGTH)
                            .map(octets -> part(octets, SRES_LENGTH, octets.length())));
        }

        private static OctetString part(OctetString octets, int from, int to) {
            return OctetString.of(Octets.range(octets.toArray(), from, to));
        }

        /** SRES or the whole RES. */
        public OctetString response() {
            OctetWriter all = new OctetWriter().string(sres);
            extension.ifPresent(all::string);
            return all.toOctetString();
        }
    }

    record AuthenticationReject() implements MobilityManagement {}

    record AuthenticationFailure(RejectCause cause, Optional<OctetString> auts) implements MobilityManagement {}

    record TmsiReallocationCommand(LocationArea area, MobileIdentity identity) implements MobilityManagement {}

    record TmsiReallocationComplete() implements MobilityManagement {}

    /** @param networkName for the phone's display, at most 64 characters; @param time with the local time zone */
    record MmInformation(String networkName, Optional<OffsetDateTime> time) implements MobilityManagement {
        public static final int MAX_NAME_LENGTH = 64;

        public MmInformation(String networkName) {
            this(networkName, Optional.empty());
        }

        public MmInformation {
            if (networkName.length() > MAX_NAME_LENGTH) {
                throw new IllegalArgumentException(
                        "a network name of " + networkName.length() + " characters, at most " + MAX_NAME_LENGTH);
            }
        }
    }

    record CmServiceRequest(ServiceType service, int keySequence, MobileIdentity identity)
            implements MobilityManagement {}

    record CmServiceAccept() implements MobilityManagement {}

    record CmServiceReject(RejectCause cause) implements MobilityManagement {}

    /** The mobile cancels its CM SERVICE REQUEST and the radio connection. */
    record CmServiceAbort() implements MobilityManagement {}

    /** The network ends all connections. @param cause 6: the equipment is illegal; 17: network failure */
    record MmAbort(RejectCause cause) implements MobilityManagement {}

    record ImsiDetachIndication(MobileIdentity identity) implements MobilityManagement {}

    record MmStatus(RejectCause cause) implements MobilityManagement {}
}
