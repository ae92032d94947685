package simgsm.air;

import static simgsm.air.Element.Format.LV;
import static simgsm.air.Element.Format.T;
import static simgsm.air.Element.Format.TLV;
import static simgsm.air.Element.Format.TV;
import static simgsm.air.Element.Format.V;
import static simgsm.air.Element.Presence.C;
import static simgsm.air.Element.Presence.M;
import static simgsm.air.Element.Presence.O;
import static simgsm.air.Element.half;
import static simgsm.air.Element.row;
import static simgsm.air.ElementType.*;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simgsm.air.CallControl.*;
import simgsm.air.MobilityManagement.*;
import simgsm.air.RadioResource.*;
import simgsm.air.ShortMessageControl.*;
import simgsm.air.SupplementaryService.*;

/**
 * All message types in use: numbers, direction, record, name and the table of elements, as TS 24.008 (9.2, 9.3), TS
 * 44.018 (9.1), TS 24.011 (7.2) and TS 24.080 (2) print them. Elements neither read nor sent by the suite are
 * omitted, except those that a receiver must understand or that have no length octet.
 */
public enum Layer3Type {
    IMSI_DETACH_INDICATION(up(5, 0x01, ImsiDetachIndication.class, "IMSI Detach Indication", "9.2.12")
            .with(row(CLASSMARK_1, M, V, 1).sends("33"))
            .with(row(MOBILE_IDENTITY, M, LV, 2, 9).to("identity"))),
    LOCATION_UPDATING_ACCEPT(down(5, 0x02, LocationUpdatingAccept.class, "Location Updating Accept", "9.2.13")
            .with(row(LOCATION_AREA, M, V, 5).to("area"))
            .with(row(0x17, MOBILE_IDENTITY, O, TLV, 3, 10).to("newIdentity"))),
    LOCATION_UPDATING_REJECT(down(5, 0x04, LocationUpdatingReject.class, "Location Updating Reject", "9.2.14")
            .with(row(REJECT_CAUSE, M, V, 1).to("cause"))),
    LOCATION_UPDATING_REQUEST(up(5, 0x08, LocationUpdatingRequest.class, "Location Updating Request", "9.2.15")
            .with(half(LOCATION_UPDATING_TYPE).to("updatingType"))
            .with(half(KEY_SEQUENCE).to("keySequence"))
            .with(row(LOCATION_AREA, M, V, 5).to("oldArea"))
            .with(row(CLASSMARK_1, M, V, 1).sends("33"))
            .with(row(MOBILE_IDENTITY, M, LV, 2, 9).to("identity"))),
    AUTHENTICATION_REJECT(down(5, 0x11, AuthenticationReject.class, "Authentication Reject", "9.2.1")),
    AUTHENTICATION_REQUEST(down(5, 0x12, AuthenticationRequest.class, "Authentication Request", "9.2.2")
            .with(half(KEY_SEQUENCE).to("keySequence"))
            .with(half(SPARE).sends("00"))
            .with(row(RAND, M, V, 16).to("rand"))
            .with(row(0x20, AUTN, O, TLV, 18).to("autn"))),
    AUTHENTICATION_RESPONSE(up(5, 0x14, AuthenticationResponse.class, "Authentication Response", "9.2.3")
            .with(row(SRES, M, V, 4).to("sres"))
            .with(row(0x21, RES_EXTENSION, O, TLV, 3, 14).to("extension"))),
    AUTHENTICATION_FAILURE(up(5, 0x1c, AuthenticationFailure.class, "Authentication Failure", "9.2.3a")
            .with(row(REJECT_CAUSE, M, V, 1).to("cause"))
            .with(row(0x22, AUTS, O, TLV, 16).to("auts"))),
    IDENTITY_REQUEST(down(5, 0x18, IdentityRequest.class, "Identity Request", "9.2.10")
            .with(half(IDENTITY_TYPE).to("identityType"))
            .with(half(SPARE).sends("00"))),
    IDENTITY_RESPONSE(up(5, 0x19, IdentityResponse.class, "Identity Response", "9.2.11")
            .with(row(MOBILE_IDENTITY, M, LV, 2, 10).to("identity"))),
    TMSI_REALLOCATION_COMMAND(down(5, 0x1a, TmsiReallocationCommand.class, "TMSI Reallocation Command", "9.2.17")
            .with(row(LOCATION_AREA, M, V, 5).to("area"))
            .with(row(MOBILE_IDENTITY, M, LV, 2, 9).to("identity"))),
    TMSI_REALLOCATION_COMPLETE(up(5, 0x1b, TmsiReallocationComplete.class, "TMSI Reallocation Complete", "9.2.18")),
    CM_SERVICE_ACCEPT(down(5, 0x21, CmServiceAccept.class, "CM Service Accept", "9.2.5")),
    CM_SERVICE_REJECT(down(5, 0x22, CmServiceReject.class, "CM Service Reject", "9.2.6")
            .with(row(REJECT_CAUSE, M, V, 1).to("cause"))),
    CM_SERVICE_ABORT(up(5, 0x23, CmServiceAbort.class, "CM Service Abort", "9.2.7")),
    CM_SERVICE_REQUEST(up(5, 0x24, CmServiceRequest.class, "CM Service Request", "9.2.9")
            .with(half(SERVICE_TYPE).to("service"))
            .with(half(KEY_SEQUENCE).to("keySequence"))
            .with(row(CLASSMARK_2, M, LV, 4).sends("331982"))
            .with(row(MOBILE_IDENTITY, M, LV, 2, 9).to("identity"))),
    MM_ABORT(down(5, 0x29, MmAbort.class, "Abort", "9.2.8")
            .with(row(REJECT_CAUSE, M, V, 1).to("cause"))),
    MM_STATUS(both(5, 0x31, MmStatus.class, "MM Status", "9.2.16")
            .with(row(REJECT_CAUSE, M, V, 1).to("cause"))),
    MM_INFORMATION(down(5, 0x32, MmInformation.class, "MM Information", "9.2.15a")
            .with(row(0x43, NETWORK_NAME, O, TLV, 3, 257)
                    .named("Full name for network")
                    .to("networkName")
                    .absentAs(""))
            .with(row(0x46, TIME_ZONE, O, TV, 2).named("Local time zone"))
            .with(row(0x47, TIME, O, TV, 8)
                    .named("Universal time and local time zone")
                    .to("time"))),

    ALERTING(both(3, 0x01, Alerting.class, "Alerting", "9.3.1")
            .with(row(0x1e, PROGRESS_INDICATOR, O, TLV, 4).to("inBand").down())),
    CALL_PROCEEDING(down(3, 0x02, CallProceeding.class, "Call Proceeding", "9.3.3")
            .with(row(0x04, BEARER_CAPABILITY, O, TLV, 3, 16))),
    PROGRESS(down(3, 0x03, Progress.class, "Progress", "9.3.17")
            .with(row(PROGRESS_INDICATOR, M, LV, 3).sends("e288"))),
    SETUP(both(3, 0x05, Setup.class, "Setup", "9.3.23")
            .with(row(0x04, BEARER_CAPABILITY, M, TLV, 3, 16)
                    .sends("600402000581")
                    .up())
            .with(row(0x04, BEARER_CAPABILITY, O, TLV, 3, 16).sends("a0").down())
            .with(row(0x34, SIGNAL, O, TV, 2).to("signal").down())
            .with(row(0x5c, CALLING_NUMBER, O, TLV, 3, 14).to("calling").down())
            .with(row(0x5e, CALLED_NUMBER, M, TLV, 3, 43).to("called").up())
            .with(row(0x5e, CALLED_NUMBER, O, TLV, 3, 19).to("called").down())
            .with(row(0x74, REDIRECTING_NUMBER, O, TLV, 3, 19).to("redirecting").down())
            .with(row(0xa2, CLIR_INVOCATION, O, T, 1).to("hidesNumber").up())),
    CONNECT(both(3, 0x07, Connect.class, "Connect", "9.3.5")
            .with(row(0x4c, CONNECTED_NUMBER, O, TLV, 3, 14).to("connected").down())),
    CALL_CONFIRMED(up(3, 0x08, CallConfirmed.class, "Call Confirmed", "9.3.2")
            .with(row(0x04, BEARER_CAPABILITY, O, TLV, 3, 16))
            .with(row(0x08, CAUSE, O, TLV, 4, 32).to("cause"))),
    EMERGENCY_SETUP(up(3, 0x0e, EmergencySetup.class, "Emergency Setup", "9.3.8")
            .with(row(0x04, BEARER_CAPABILITY, O, TLV, 3, 11).sends("600402000581"))),
    CONNECT_ACKNOWLEDGE(both(3, 0x0f, ConnectAcknowledge.class, "Connect Acknowledge", "9.3.6")),
    HOLD(up(3, 0x18, Hold.class, "Hold", "9.3.10")),
    HOLD_ACKNOWLEDGE(down(3, 0x19, HoldAcknowledge.class, "Hold Acknowledge", "9.3.11")),
    HOLD_REJECT(down(3, 0x1a, HoldReject.class, "Hold Reject", "9.3.12")
            .with(row(CAUSE, M, LV, 3, 31).to("cause"))),
    RETRIEVE(up(3, 0x1c, Retrieve.class, "Retrieve", "9.3.20")),
    RETRIEVE_ACKNOWLEDGE(down(3, 0x1d, RetrieveAcknowledge.class, "Retrieve Acknowledge", "9.3.21")),
    RETRIEVE_REJECT(down(3, 0x1e, RetrieveReject.class, "Retrieve Reject", "9.3.22")
            .with(row(CAUSE, M, LV, 3, 31).to("cause"))),
    DISCONNECT(both(3, 0x25, Disconnect.class, "Disconnect", "9.3.7")
            .with(row(LOCATED_CAUSE, M, LV, 3, 31).to("cause", "location"))
            .with(row(0x1e, PROGRESS_INDICATOR, O, TLV, 4).to("inBand").down())),
    RELEASE_COMPLETE(both(3, 0x2a, ReleaseComplete.class, "Release Complete", "9.3.19")
            .with(row(0x08, LOCATED_CAUSE, O, TLV, 4, 32).to("cause", "location"))),
    RELEASE(both(3, 0x2d, Release.class, "Release", "9.3.18")
            .with(row(0x08, LOCATED_CAUSE, O, TLV, 4, 32).to("cause", "location"))),
    STOP_DTMF(up(3, 0x31, StopDtmf.class, "Stop DTMF", "9.3.29")),
    STOP_DTMF_ACKNOWLEDGE(down(3, 0x32, StopDtmfAcknowledge.class, "Stop DTMF Acknowledge", "9.3.30")),
    STATUS_ENQUIRY(both(3, 0x34, StatusEnquiry.class, "Status Enquiry", "9.3.28")),
    START_DTMF(up(3, 0x35, StartDtmf.class, "Start DTMF", "9.3.24")
            .with(row(0x2c, KEYPAD_FACILITY, M, TV, 2).to("key"))),
    START_DTMF_ACKNOWLEDGE(down(3, 0x36, StartDtmfAcknowledge.class, "Start DTMF Acknowledge", "9.3.25")
            .with(row(0x2c, KEYPAD_FACILITY, M, TV, 2).to("key"))),
    START_DTMF_REJECT(down(3, 0x37, StartDtmfReject.class, "Start DTMF Reject", "9.3.26")
            .with(row(CAUSE, M, LV, 3, 31).to("cause"))),
    FACILITY(both(3, 0x3a, Facility.class, "Facility", "9.3.9")
            .with(row(ElementType.FACILITY, M, LV, 1, 256).to("facility"))),
    STATUS(both(3, 0x3d, Status.class, "Status", "9.3.27")
            .with(row(CAUSE, M, LV, 3, 31).to("cause"))
            .with(row(CALL_STATE, M, V, 1).to("callState"))),

    HANDOVER_COMMAND(down(6, 0x2b, HandoverCommand.class, "Handover Command", "9.1.15")
            .with(row(CELL_DESCRIPTION, M, V, 2).to("cell"))
            .with(row(CHANNEL_DESCRIPTION, M, V, 3).to("channel"))
            .with(row(HANDOVER_REFERENCE, M, V, 1).to("reference"))
            .with(row(POWER_AND_ACCESS, M, V, 1).to("powerLevel"))
            .with(row(0x63, CHANNEL_MODE, O, TV, 2).to("channelMode"))
            .with(row(0x03, MULTI_RATE, O, TLV, 4, 8))
            .with(row(0x05, FREQUENCY_LIST, C, TLV, 4, 133))),
    HANDOVER_COMPLETE(up(6, 0x2c, HandoverComplete.class, "Handover Complete", "9.1.16")
            .with(row(RR_CAUSE, M, V, 1).to("cause"))),
    HANDOVER_FAILURE(up(6, 0x28, HandoverFailure.class, "Handover Failure", "9.1.17")
            .with(row(RR_CAUSE, M, V, 1).to("cause"))),
    PHYSICAL_INFORMATION(down(6, 0x2d, PhysicalInformation.class, "Physical Information", "9.1.28")
            .with(row(TIMING_ADVANCE, M, V, 1).to("timingAdvance"))),
    ASSIGNMENT_COMMAND(down(6, 0x2e, AssignmentCommand.class, "Assignment Command", "9.1.2")
            .with(row(CHANNEL_DESCRIPTION, M, V, 3).to("channel"))
            .with(row(POWER_COMMAND, M, V, 1).to("powerLevel"))
            .with(row(0x63, CHANNEL_MODE, O, TV, 2).to("channelMode").absentAs(RadioResource.SPEECH_FULL_RATE))
            .with(row(0x03, MULTI_RATE, O, TLV, 4, 8))
            .with(row(0x05, FREQUENCY_LIST, C, TLV, 4, 133))),
    ASSIGNMENT_COMPLETE(up(6, 0x29, AssignmentComplete.class, "Assignment Complete", "9.1.3")
            .with(row(RR_CAUSE, M, V, 1).to("cause"))),
    ASSIGNMENT_FAILURE(up(6, 0x2f, AssignmentFailure.class, "Assignment Failure", "9.1.4")
            .with(row(RR_CAUSE, M, V, 1).to("cause"))),
    CHANNEL_MODE_MODIFY(down(6, 0x10, ChannelModeModify.class, "Channel Mode Modify", "9.1.5")
            .with(row(CHANNEL_DESCRIPTION, M, V, 3).to("channel"))
            .with(row(CHANNEL_MODE, M, V, 1).to("mode"))),
    CHANNEL_MODE_MODIFY_ACKNOWLEDGE(
            up(6, 0x17, ChannelModeModifyAcknowledge.class, "Channel Mode Modify Acknowledge", "9.1.6")
                    .with(row(CHANNEL_DESCRIPTION, M, V, 3).to("channel"))
                    .with(row(CHANNEL_MODE, M, V, 1).to("mode"))),
    MEASUREMENT_REPORT(up(6, 0x15, MeasurementReport.class, "Measurement Report", "9.1.21")
            .with(row(MEASUREMENT_RESULTS, M, V, 16).to("results"))),
    CHANNEL_RELEASE(down(6, 0x0d, ChannelRelease.class, "Channel Release", "9.1.7")
            .with(row(RR_CAUSE, M, V, 1).to("cause"))),
    RR_STATUS(both(6, 0x12, RrStatus.class, "RR Status", "9.1.29")
            .with(row(RR_CAUSE, M, V, 1).to("cause"))),
    CIPHERING_MODE_COMMAND(down(6, 0x35, CipheringModeCommand.class, "Ciphering Mode Command", "9.1.9")
            .with(half(CIPHER_MODE_SETTING).to("algorithm"))
            .with(half(CIPHER_RESPONSE).to("response"))),
    CIPHERING_MODE_COMPLETE(up(6, 0x32, CipheringModeComplete.class, "Ciphering Mode Complete", "9.1.10")
            .with(row(0x17, MOBILE_IDENTITY, O, TLV, 3, 11).to("equipment"))),
    CLASSMARK_ENQUIRY(down(6, 0x13, ClassmarkEnquiry.class, "Classmark Enquiry", "9.1.12")),
    CLASSMARK_CHANGE(up(6, 0x16, ClassmarkChange.class, "Classmark Change", "9.1.11")
            .with(row(CLASSMARK_2, M, LV, 4).sends("331982"))
            .with(row(0x20, CLASSMARK_3, C, TLV, 3, 34).sends("601400"))),
    PAGING_RESPONSE(up(6, 0x27, PagingResponse.class, "Paging Response", "9.1.25")
            .with(half(KEY_SEQUENCE).to("keySequence"))
            .with(half(SPARE).sends("00"))
            .with(row(CLASSMARK_2, M, LV, 4).sends("331982"))
            .with(row(MOBILE_IDENTITY, M, LV, 2, 9).to("identity"))),

    CP_DATA(both(9, 0x01, CpData.class, "CP-DATA", "7.2.1")
            .with(row(CP_USER_DATA, M, LV, 1, 249).to("relay"))),
    CP_ACK(both(9, 0x04, CpAck.class, "CP-ACK", "7.2.2")),
    CP_ERROR(both(9, 0x10, CpError.class, "CP-ERROR", "7.2.3")
            .with(row(CP_CAUSE, M, V, 1).to("cause"))),

    SS_RELEASE_COMPLETE(both(11, 0x2a, SsReleaseComplete.class, "Release Complete", "2.5")
            .with(row(0x08, CAUSE, O, TLV, 4, 32).to("cause"))
            .with(row(0x1c, ElementType.FACILITY, O, TLV, 2, 257).to("facility"))),
    SS_FACILITY(both(11, 0x3a, SsFacility.class, "Facility", "2.3")
            .with(row(ElementType.FACILITY, M, LV, 1, 256).to("facility"))),
    SS_REGISTER(both(11, 0x3b, SsRegister.class, "Register", "2.4")
            .with(row(0x1c, ElementType.FACILITY, M, TLV, 2, 257).to("facility"))
            .with(row(0x7f, SS_VERSION, O, TLV, 3).to("version").up()));

    private enum Way {
        UP,
        DOWN,
        BOTH
    }

    private static final Layer3Type[] BY_NUMBERS = new Layer3Type[16 * 256];
    private static final Map<Class<?>, Layer3Type> BY_RECORD = new HashMap<>();

    static {
        for (Layer3Type type : values()) {
            BY_NUMBERS[type.head.discriminator << 8 | type.head.code] = type;
            BY_RECORD.put(type.head.record, type);
        }
    }

    /** A row of the list above, before its elements. */
    private record Head(
            int discriminator,
            int code,
            Way way,
            Class<? extends Layer3Message> record,
            String title,
            String clause,
            List<Element> rows) {
        Head with(Element row) {
            rows.add(row);
            return this;
        }
    }

    private final Head head;
    private final ElementTable table;

    Layer3Type(Head head) {
        this.head = head;
        table = new ElementTable(head.record, head.rows);
    }

    private static Head up(int pd, int code, Class<? extends Layer3Message> record, String title, String clause) {
        return new Head(pd, code, Way.UP, record, title, clause, new ArrayList<>());
    }

    private static Head down(int pd, int code, Class<? extends Layer3Message> record, String title, String clause) {
        return new Head(pd, code, Way.DOWN, record, title, clause, new ArrayList<>());
    }

    private static Head both(int pd, int code, Class<? extends Layer3Message> record, String title, String clause) {
        return new Head(pd, code, Way.BOTH, record, title, clause, new ArrayList<>());
    }

    /** The type of a message. */
    public static Layer3Type of(Layer3Message message) {
        return BY_RECORD.get(message.getClass());
    }

    /** The type with these numbers; empty if unknown or not used in this direction. */
    public static Optional<Layer3Type> of(int discriminator, int code, Direction direction) {
        Layer3Type type = BY_NUMBERS[(discriminator & 0x0f) << 8 | code & 0xff];
        return type == null || !type.goes(direction) ? Optional.empty() : Optional.of(type);
    }

    /** The protocol discriminator; see {@link Layer3Header}. */
    public int discriminator() {
        return head.discriminator;
    }

    /** The message type octet, without the send sequence number. */
    public int code() {
        return head.code;
    }

    /** The message's name in the standard. */
    public String title() {
        return head.title;
    }

    /** The clause of the message's table: in TS 24.008, for radio resource TS 44.018, SMS TS 24.011, SS TS 24.080. */
    public String clause() {
        return head.clause;
    }

    /** The rows of the message's table in this direction. */
    public List<Element> elements(Direction direction) {
        return table.rows(direction);
    }

    ElementTable table() {
        return table;
    }

    /** True if messages of this type are sent in this direction. */
    public boolean goes(Direction direction) {
        return head.way == Way.BOTH || (head.way == Way.UP) == (direction == Direction.UPLINK);
    }
}
