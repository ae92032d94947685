package simgsm.station;

import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.Optional;
import simgsm.air.Direction;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.RelayMessage.RpAck;
import simgsm.air.RelayMessage.RpData;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;
import simgsm.octets.Timestamp;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.SmsAddress;
import simgsm.sms.StatusReportTpdu;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.station.context.StationIdentity;

/** A registered station and a network, played by hand, that takes and brings short messages. */
abstract class MessageStage {
    static final TransactionIdentifier THEIRS = new TransactionIdentifier(2, false);
    static final Timestamp NOON = Timestamp.of(OffsetDateTime.of(2026, 11, 21, 12, 0, 0, 0, ZoneOffset.UTC));

    final Scene scene = Scene.registered();

    /** Reads the next CP-DATA and the SUBMIT within. */
    CpData expectSubmit() {
        return scene.expect(CpData.class);
    }

    static SubmitTpdu submitIn(CpData data) {
        try {
            return (SubmitTpdu) TpduCodec.decode(((RpData) data.relay()).tpdu(), Direction.UPLINK);
        } catch (ProtocolViolation e) {
            throw new AssertionError(e);
        }
    }

    void acknowledge(CpData data) {
        scene.down(new CpAck(data.transaction().answered()));
        scene.down(
                new CpData(data.transaction().answered(), new RpAck(data.relay().reference(), Optional.empty())));
    }

    void openForDelivery() {
        scene.page(Scene.TMSI);
        scene.expectFirst(PagingResponse.class);
    }

    static OctetString deliver(UserData data) {
        return TpduCodec.encode(new DeliverTpdu(false, false, false, SmsAddress.of(Scene.OTHER), 0, NOON, data));
    }

    void down(int reference, OctetString tpdu) {
        scene.down(new CpData(THEIRS, new RpData(reference, StationIdentity.TEST_SERVICE_CENTER, tpdu)));
    }

    /** A whole delivery as the network sees it. */
    void delivered(int reference, OctetString tpdu) {
        down(reference, tpdu);
        scene.expect(new CpAck(THEIRS.answered()));
        scene.expect(new CpData(THEIRS.answered(), new RpAck(reference, Optional.empty())));
        scene.down(new CpAck(THEIRS));
    }

    static OctetString report(int reference, int status) {
        Tpdu report = new StatusReportTpdu(false, reference, SmsAddress.of(Scene.OTHER), NOON, NOON, status);
        return TpduCodec.encode(report);
    }
}
