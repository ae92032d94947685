package simgsm.air;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import simgsm.air.CallControl.*;
import simgsm.air.MobilityManagement.*;
import simgsm.air.RadioResource.*;
import simgsm.air.ShortMessageControl.*;
import simgsm.air.SupplementaryService.*;

/** All message types in use: numbers, direction, record and name (TS 24.008, 10.4; TS 24.011, 8.1.3; TS 24.080, 3.4). */
public enum Layer3Type {
    IMSI_DETACH_INDICATION(5, 0x01, Way.UP, ImsiDetachIndication.class, "IMSI Detach Indication"),
    LOCATION_UPDATING_ACCEPT(5, 0x02, Way.DOWN, LocationUpdatingAccept.class, "Location Updating Accept"),
    LOCATION_UPDATING_REJECT(5, 0x04, Way.DOWN, LocationUpdatingReject.class, "Location Updating Reject"),
    LOCATION_UPDATING_REQUEST(5, 0x08, Way.UP, LocationUpdatingRequest.class, "Location Updating Request"),
    AUTHENTICATION_REJECT(5, 0x11, Way.DOWN, AuthenticationReject.class, "Authentication Reject"),
    AUTHENTICATION_REQUEST(5, 0x12, Way.DOWN, AuthenticationRequest.class, "Authentication Request"),
    AUTHENTICATION_RESPONSE(5, 0x14, Way.UP, AuthenticationResponse.class, "Authentication Response"),
    AUTHENTICATION_FAILURE(5, 0x1c, Way.UP, AuthenticationFailure.class, "Authentication Failure"),
    IDENTITY_REQUEST(5, 0x18, Way.DOWN, IdentityRequest.class, "Identity Request"),
    IDENTITY_RESPONSE(5, 0x19, Way.UP, IdentityResponse.class, "Identity Response"),
    TMSI_REALLOCATION_COMPLETE(5, 0x1b, Way.UP, TmsiReallocationComplete.class, "TMSI Reallocation Complete"),
    CM_SERVICE_ACCEPT(5, 0x21, Way.DOWN, CmServiceAccept.class, "CM Service Accept"),
    CM_SERVICE_REJECT(5, 0x22, Way.DOWN, CmServiceReject.class, "CM Service Reject"),
    CM_SERVICE_ABORT(5, 0x23, Way.UP, CmServiceAbort.class, "CM Service Abort"),
    CM_SERVICE_REQUEST(5, 0x24, Way.UP, CmServiceRequest.class, "CM Service Request"),
    MM_STATUS(5, 0x31, Way.BOTH, MmStatus.class, "MM Status"),
    MM_INFORMATION(5, 0x32, Way.DOWN, MmInformation.class, "MM Information"),

    ALERTING(3, 0x01, Way.BOTH, Alerting.class, "Alerting"),
    CALL_PROCEEDING(3, 0x02, Way.DOWN, CallProceeding.class, "Call Proceeding"),
    PROGRESS(3, 0x03, Way.DOWN, Progress.class, "Progress"),
    SETUP(3, 0x05, Way.BOTH, Setup.class, "Setup"),
    CONNECT(3, 0x07, Way.BOTH, Connect.class, "Connect"),
    CALL_CONFIRMED(3, 0x08, Way.UP, CallConfirmed.class, "Call Confirmed"),
    CONNECT_ACKNOWLEDGE(3, 0x0f, Way.BOTH, ConnectAcknowledge.class, "Connect Acknowledge"),
    HOLD(3, 0x18, Way.UP, Hold.class, "Hold"),
    HOLD_ACKNOWLEDGE(3, 0x19, Way.DOWN, HoldAcknowledge.class, "Hold Acknowledge"),
    HOLD_REJECT(3, 0x1a, Way.DOWN, HoldReject.class, "Hold Reject"),
    RETRIEVE(3, 0x1c, Way.UP, Retrieve.class, "Retrieve"),
    RETRIEVE_ACKNOWLEDGE(3, 0x1d, Way.DOWN, RetrieveAcknowledge.class, "Retrieve Acknowledge"),
    RETRIEVE_REJECT(3, 0x1e, Way.DOWN, RetrieveReject.class, "Retrieve Reject"),
    DISCONNECT(3, 0x25, Way.BOTH, Disconnect.class, "Disconnect"),
    RELEASE_COMPLETE(3, 0x2a, Way.BOTH, ReleaseComplete.class, "Release Complete"),
    RELEASE(3, 0x2d, Way.BOTH, Release.class, "Release"),
    STOP_DTMF(3, 0x31, Way.UP, StopDtmf.class, "Stop DTMF"),
    STOP_DTMF_ACKNOWLEDGE(3, 0x32, Way.DOWN, StopDtmfAcknowledge.class, "Stop DTMF Acknowledge"),
    STATUS_ENQUIRY(3, 0x34, Way.BOTH, StatusEnquiry.class, "Status Enquiry"),
    START_DTMF(3, 0x35, Way.UP, StartDtmf.class, "Start DTMF"),
    START_DTMF_ACKNOWLEDGE(3, 0x36, Way.DOWN, StartDtmfAcknowledge.class, "Start DTMF Acknowledge"),
    START_DTMF_REJECT(3, 0x37, Way.DOWN, StartDtmfReject.class, "Start DTMF Reject"),
    FACILITY(3, 0x3a, Way.BOTH, Facility.class, "Facility"),
    STATUS(3, 0x3d, Way.BOTH, Status.class, "Status"),

    HANDOVER_COMMAND(6, 0x2b, Way.DOWN, HandoverCommand.class, "Handover Command"),
    HANDOVER_COMPLETE(6, 0x2c, Way.UP, HandoverComplete.class, "Handover Complete"),
    HANDOVER_FAILURE(6, 0x28, Way.UP, HandoverFailure.class, "Handover Failure"),
    PHYSICAL_INFORMATION(6, 0x2d, Way.DOWN, PhysicalInformation.class, "Physical Information"),
    ASSIGNMENT_COMMAND(6, 0x2e, Way.DOWN, AssignmentCommand.class, "Assignment Command"),
    ASSIGNMENT_COMPLETE(6, 0x29, Way.UP, AssignmentComplete.class, "Assignment Complete"),
    ASSIGNMENT_FAILURE(6, 0x2f, Way.UP, AssignmentFailure.class, "Assignment Failure"),
    CHANNEL_MODE_MODIFY(6, 0x10, Way.DOWN, ChannelModeModify.class, "Channel Mode Modify"),
    CHANNEL_MODE_MODIFY_ACKNOWLEDGE(
            6, 0x17, Way.UP, ChannelModeModifyAcknowledge.class, "Channel Mode Modify Acknowledge"),
    MEASUREMENT_REPORT(6, 0x15, Way.UP, MeasurementReport.class, "Measurement Report"),
    CHANNEL_RELEASE(6, 0x0d, Way.DOWN, ChannelRelease.class, "Channel Release"),
    RR_STATUS(6, 0x12, Way.BOTH, RrStatus.class, "RR Status"),
    PAGING_RESPONSE(6, 0x27, Way.UP, PagingResponse.class, "Paging Response"),

    CP_DATA(9, 0x01, Way.BOTH, CpData.class, "CP-DATA"),
    CP_ACK(9, 0x04, Way.BOTH, CpAck.class, "CP-ACK"),
    CP_ERROR(9, 0x10, Way.BOTH, CpError.class, "CP-ERROR"),

    SS_RELEASE_COMPLETE(11, 0x2a, Way.BOTH, SsReleaseComplete.class, "Release Complete"),
    SS_FACILITY(11, 0x3a, Way.BOTH, SsFacility.class, "Facility"),
    SS_REGISTER(11, 0x3b, Way.BOTH, SsRegister.class, "Register");

    private enum Way {
        UP,
        DOWN,
        BOTH
    }

    private static final Layer3Type[] BY_NUMBERS = new Layer3Type[16 * 256];
    private static final Map<Class<?>, Layer3Type> BY_RECORD = new HashMap<>();

    static {
        for (Layer3Type type : values()) {
            BY_NUMBERS[type.discriminator << 8 | type.code] = type;
            BY_RECORD.put(type.record, type);
        }
    }

    private final int discriminator;
    private final int code;
    private final Way way;
    private final Class<? extends Layer3Message> record;
    private final String title;

    Layer3Type(int discriminator, int code, Way way, Class<? extends Layer3Message> record, String title) {
        this.discriminator = discriminator;
        this.code = code;
        this.way = way;
        this.record = record;
        this.title = title;
    }

    /** The type of a message. */
    public static Layer3Type of(Layer3Message message) {
        return BY_RECORD.get(message.getClass());
    }

    /** The type with these numbers; empty if it is not known or never goes in this direction. */
    public static Optional<Layer3Type> of(int discriminator, int code, Direction direction) {
        Layer3Type type = BY_NUMBERS[(discriminator & 0x0f) << 8 | code & 0xff];
        return type == null || !type.goes(direction) ? Optional.empty() : Optional.of(type);
    }

    /** The protocol discriminator; see {@link Layer3Header}. */
    public int discriminator() {
        return discriminator;
    }

    /** The message type octet, without the send sequence number. */
    public int code() {
        return code;
    }

    /** The message's name in the standard. */
    public String title() {
        return title;
    }

    /** Whether messages of this type are sent in this direction. */
    public boolean goes(Direction direction) {
        return way == Way.BOTH || (way == Way.UP) == (direction == Direction.UPLINK);
    }
}
