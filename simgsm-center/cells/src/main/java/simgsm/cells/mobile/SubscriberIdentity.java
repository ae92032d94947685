package simgsm.cells.mobile;

import java.util.Optional;
import simgsm.air.Direction;
import simgsm.air.Imsi;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.IdentityResponse;
import simgsm.air.MobilityManagement.ImsiDetachIndication;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.Tmsi;
import simgsm.octets.OctetString;

/** A terminal's identity, read from its messages; the radio part needs it for paging. */
final class SubscriberIdentity {
    private static final int GROUP_DIGITS = 3;

    private Optional<Imsi> imsi = Optional.empty();
    private Optional<Tmsi> tmsi = Optional.empty();

    /**
     * Reads a message of the terminal.
     *
     * @return true if the IMSI has become known
     */
    boolean readUplink(OctetString layer3) {
        Optional<Imsi> before = imsi;
        identityIn(layer3).ifPresent(identity -> {
            if (identity instanceof Imsi known) {
                imsi = Optional.of(known);
            } else if (identity instanceof Tmsi temporary) {
                tmsi = Optional.of(temporary);
            }
        });
        return !imsi.equals(before);
    }

    private static Optional<MobileIdentity> identityIn(OctetString layer3) {
        try {
            Layer3Message message = Layer3Codec.decode(layer3.toArray(), Direction.UPLINK);
            if (message instanceof LocationUpdatingRequest request) {
                return Optional.of(request.identity());
            } else if (message instanceof CmServiceRequest request) {
                return Optional.of(request.identity());
            } else if (message instanceof PagingResponse response) {
                return Optional.of(response.identity());
            } else if (message instanceof IdentityResponse response) {
                return Optional.of(response.identity());
            } else if (message instanceof ImsiDetachIndication detach) {
                return Optional.of(detach.identity());
            }
        } catch (ProtocolViolation unknown) {
            // the network answers it
        }
        return Optional.empty();
    }

    /** Reads a message for the terminal. @return the area of a LOCATION UPDATING ACCEPT */
    Optional<Integer> readDownlink(OctetString layer3) {
        try {
            if (Layer3Codec.decode(layer3.toArray(), Direction.DOWNLINK) instanceof LocationUpdatingAccept accept) {
                accept.newIdentity().ifPresent(identity -> {
                    if (identity instanceof Tmsi temporary) {
                        tmsi = Optional.of(temporary);
                    } else if (identity instanceof Imsi) {
                        tmsi = Optional.empty();
                    }
                });
                return Optional.of(accept.area().areaCode());
            }
        } catch (ProtocolViolation unknown) {
            // the terminal answers it
        }
        return Optional.empty();
    }

    /** True if paging of this identity in this group reaches the mobile; any group does while its IMSI is unknown. */
    boolean isPaged(MobileIdentity identity, int group, int groups) {
        boolean isInGroup = imsi.isEmpty() || pagingGroup(imsi.get(), groups) == group;
        return isInGroup && isOwn(identity);
    }

    private boolean isOwn(MobileIdentity identity) {
        return identity instanceof Imsi
                ? imsi.isPresent() && imsi.get().equals(identity)
                : tmsi.isPresent() && tmsi.get().equals(identity);
    }

    /** TS 45.002, 6.5.2, with one control channel. */
    static int pagingGroup(Imsi imsi, int groups) {
        String digits = imsi.digits();
        return Integer.parseInt(digits.substring(digits.length() - GROUP_DIGITS)) % groups;
    }

    /** The number in an open network, else the IMSI; empty while that is unknown. */
    Optional<String> number() {
        return imsi.map(known -> known.openNumber().map(Msisdn::digits).orElse(known.digits()));
    }
}
