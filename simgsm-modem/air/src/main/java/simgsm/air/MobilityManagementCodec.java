package simgsm.air;

import java.util.Optional;
import simgsm.air.MobilityManagement.AuthenticationFailure;
import simgsm.air.MobilityManagement.AuthenticationReject;
import simgsm.air.MobilityManagement.AuthenticationRequest;
import simgsm.air.MobilityManagement.AuthenticationResponse;
import simgsm.air.MobilityManagement.CmServiceAbort;
import simgsm.air.MobilityManagement.CmServiceAccept;
import simgsm.air.MobilityManagement.CmServiceReject;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.IdentityRequest;
import simgsm.air.MobilityManagement.IdentityResponse;
import simgsm.air.MobilityManagement.ImsiDetachIndication;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingReject;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.MobilityManagement.LocationUpdatingType;
import simgsm.air.MobilityManagement.MmInformation;
import simgsm.air.MobilityManagement.MmStatus;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.MobilityManagement.TmsiReallocationComplete;
import simgsm.air.OptionalElements.FixedElements;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** What follows the message type in mobility management messages (TS 24.008, 9.2). */
final class MobilityManagementCodec {
    private static final int MOBILE_IDENTITY = 0x17;
    private static final int AUTN = 0x20;
    private static final int RESPONSE_EXTENSION = 0x21;
    private static final int AUTS = 0x22;
    private static final int FULL_NETWORK_NAME = 0x43;

    /** Classmark 1: phase 2 mobile, early classmark sending, no A5/1, class 4. */
    static final int CLASSMARK_1 = 0x33;
    /** Classmark 2 as length and value: the same, with short messages on SAPI 3 possible. */
    static final OctetString CLASSMARK_2 = OctetString.ofHex("03331981");

    private static final int SRES_LENGTH = 4;

    private MobilityManagementCodec() {}

    static void write(OctetWriter out, MobilityManagement message) {
        if (message instanceof LocationUpdatingRequest request) {
            out.octet(request.keySequence() << 4 | request.updatingType().ordinal());
            IdentityElements.writeArea(out, request.oldArea());
            IdentityElements.writeIdentity(out.octet(CLASSMARK_1), request.identity());
        } else if (message instanceof LocationUpdatingAccept accept) {
            IdentityElements.writeArea(out, accept.area());
            accept.newIdentity()
                    .ifPresent(identity -> IdentityElements.writeIdentity(out.octet(MOBILE_IDENTITY), identity));
        } else if (message instanceof ImsiDetachIndication detach) {
            IdentityElements.writeIdentity(out.octet(CLASSMARK_1), detach.identity());
        } else if (message instanceof IdentityRequest request) {
            out.octet(request.identityType().code());
        } else if (message instanceof IdentityResponse response) {
            IdentityElements.writeIdentity(out, response.identity());
        } else if (message instanceof CmServiceRequest request) {
            out.octet(request.keySequence() << 4 | request.service().code()).string(CLASSMARK_2);
            IdentityElements.writeIdentity(out, request.identity());
        } else if (message instanceof MmInformation information) {
            NetworkName.write(out.octet(FULL_NETWORK_NAME), information.networkName());
        } else {
            writeSecurity(out, message);
        }
    }

    private static void writeSecurity(OctetWriter out, MobilityManagement message) {
        if (message instanceof AuthenticationRequest request) {
            out.octet(request.keySequence()).string(request.rand());
            request.autn().ifPresent(autn -> writeElement(out, AUTN, autn));
        } else if (message instanceof AuthenticationResponse response) {
            writeResponse(out, response.response().toArray());
        } else if (message instanceof AuthenticationFailure failure) {
            out.octet(failure.cause().code());
            failure.auts().ifPresent(auts -> writeElement(out, AUTS, auts));
        } else if (message instanceof LocationUpdatingReject reject) {
            out.octet(reject.cause().code());
        } else if (message instanceof CmServiceReject reject) {
            out.octet(reject.cause().code());
        } else if (message instanceof MmStatus status) {
            out.octet(status.cause().code());
        }
    }

    private static void writeResponse(OctetWriter out, byte[] response) {
        for (int i = 0; i < response.length; i++) {
            if (i == SRES_LENGTH) {
                out.octet(RESPONSE_EXTENSION).octet(response.length - SRES_LENGTH);
            }
            out.octet(response[i]);
        }
    }

    private static void writeElement(OctetWriter out, int identifier, OctetString value) {
        out.octet(identifier).octet(value.length()).string(value);
    }

    static MobilityManagement read(Layer3Type type, MessageReader in, Direction direction) throws ProtocolViolation {
        MobilityManagement message = switch (type) {
            case LOCATION_UPDATING_REQUEST -> readLocationUpdatingRequest(in);
            case LOCATION_UPDATING_ACCEPT -> readLocationUpdatingAccept(in);
            case LOCATION_UPDATING_REJECT -> new LocationUpdatingReject(readCause(in, direction));
            case IDENTITY_REQUEST -> new IdentityRequest(identityType(in.octet("identity type") & 0x07));
            case IDENTITY_RESPONSE -> new IdentityResponse(IdentityElements.readIdentity(in));
            case AUTHENTICATION_REQUEST -> readAuthenticationRequest(in);
            case AUTHENTICATION_RESPONSE -> readAuthenticationResponse(in);
            case AUTHENTICATION_REJECT -> new AuthenticationReject();
            case AUTHENTICATION_FAILURE ->
                new AuthenticationFailure(
                        readCause(in, direction), element(in, AUTS, AuthenticationFailure.AUTS_LENGTH));
            case TMSI_REALLOCATION_COMPLETE -> new TmsiReallocationComplete();
            case CM_SERVICE_REQUEST -> readCmServiceRequest(in);
            case CM_SERVICE_ACCEPT -> new CmServiceAccept();
            case CM_SERVICE_ABORT -> new CmServiceAbort();
            case CM_SERVICE_REJECT -> new CmServiceReject(readCause(in, direction));
            case IMSI_DETACH_INDICATION -> readImsiDetach(in);
            case MM_INFORMATION -> readInformation(in);
            default -> new MmStatus(readCause(in, direction));
        };
        optional(in).skipAll();
        return message;
    }

    private static RejectCause readCause(MessageReader in, Direction direction) throws ProtocolViolation {
        return RejectCause.ofCode(in.octet("reject cause"), direction);
    }

    private static AuthenticationRequest readAuthenticationRequest(MessageReader in) throws ProtocolViolation {
        int keySequence = in.octet("key sequence") & 0x07;
        OctetString rand = in.string(AuthenticationRequest.RAND_LENGTH, "RAND");
        return new AuthenticationRequest(keySequence, rand, element(in, AUTN, AuthenticationRequest.AUTN_LENGTH));
    }

    private static ImsiDetachIndication readImsiDetach(MessageReader in) throws ProtocolViolation {
        in.octet("classmark 1");
        return new ImsiDetachIndication(IdentityElements.readIdentity(in));
    }

    private static LocationUpdatingRequest readLocationUpdatingRequest(MessageReader in) throws ProtocolViolation {
        int typeAndKey = in.octet("location updating type");
        int type = typeAndKey & 0x03;
        if (type >= LocationUpdatingType.values().length) {
            throw ProtocolViolation.invalid("location updating type " + type + " is not 0 to 2");
        }
        LocationArea area = IdentityElements.readArea(in);
        in.octet("classmark 1");
        return new LocationUpdatingRequest(
                LocationUpdatingType.values()[type], typeAndKey >> 4 & 0x07, area, IdentityElements.readIdentity(in));
    }

    private static LocationUpdatingAccept readLocationUpdatingAccept(MessageReader in) throws ProtocolViolation {
        LocationArea area = IdentityElements.readArea(in);
        Optional<MessageReader> identity = optional(in).first(MOBILE_IDENTITY);
        return new LocationUpdatingAccept(area, identity.flatMap(IdentityElements::readOptional));
    }

    private static CmServiceRequest readCmServiceRequest(MessageReader in) throws ProtocolViolation {
        int serviceAndKey = in.octet("CM service type");
        int code = serviceAndKey & 0x0f;
        ServiceType service = Coded.find(ServiceType.values(), code)
                .orElseThrow(() -> ProtocolViolation.invalid("CM service type " + code + " is none of 1, 2, 4, 8"));
        in.lengthAndValue("classmark 2");
        return new CmServiceRequest(service, serviceAndKey >> 4 & 0x07, IdentityElements.readIdentity(in));
    }

    private static AuthenticationResponse readAuthenticationResponse(MessageReader in) throws ProtocolViolation {
        OctetWriter all = new OctetWriter().string(in.string(SRES_LENGTH, "SRES"));
        optional(in)
                .first(RESPONSE_EXTENSION)
                .filter(extension -> extension.remaining() <= AuthenticationResponse.MAX_LENGTH - SRES_LENGTH)
                .ifPresent(extension -> all.string(extension.rest()));
        return new AuthenticationResponse(all.toOctetString());
    }

    private static MmInformation readInformation(MessageReader in) throws ProtocolViolation {
        Optional<MessageReader> name = optional(in).first(FULL_NETWORK_NAME);
        return new MmInformation(name.isPresent() ? NetworkName.read(name.get()) : "");
    }

    private static MobileIdentity.Type identityType(int code) throws ProtocolViolation {
        return Coded.find(MobileIdentity.Type.values(), code)
                .orElseThrow(() -> ProtocolViolation.invalid("identity type " + code + " is not 1 to 4"));
    }

    /** An optional element of exactly this length; one of another length counts as absent. */
    private static Optional<OctetString> element(MessageReader in, int identifier, int length)
            throws ProtocolViolation {
        return optional(in)
                .first(identifier)
                .filter(value -> value.remaining() == length)
                .map(MessageReader::rest);
    }

    private static OptionalElements optional(MessageReader in) {
        return new OptionalElements(in, FixedElements.MOBILITY_MANAGEMENT);
    }
}
