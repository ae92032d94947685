package simgsm.center.msc.mobility;

import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.center.msc.link.Link;

/** Connections for emergency calls, which need neither registration nor card (TS 24.008, 4.5.1.5). */
final class EmergencyCalls {
    private static final String EMERGENCY = "911";
    private static final int CALLBACK_DIGITS = 7;

    private EmergencyCalls() {}

    static boolean isAskedBy(MobilityManagement.CmServiceRequest request) {
        return request.service() == MobilityManagement.ServiceType.EMERGENCY_CALL;
    }

    /** Accepts the request of any mobile. @param identity as named, perhaps of a mobile that is not registered */
    static void admit(Link link, MobileIdentity identity) {
        if (link.rateLimits().admitCall()) {
            link.send(new MobilityManagement.CmServiceAccept());
            Msisdn callback = callbackNumber(identity);
            link.name(callback.digits());
            link.radio().awaitEmergencyCall(callback);
        } else {
            link.send(new MobilityManagement.CmServiceReject(RejectCause.CONGESTION));
        }
    }

    /** 911 and the last 7 digits of the identity: shown for a mobile without a number (J-STD-036, annex C). */
    private static Msisdn callbackNumber(MobileIdentity identity) {
        String digits = "0000000"
                + (identity instanceof Imei imei ? imei.digits() : identity instanceof Imsi imsi ? imsi.digits() : "");
        return new Msisdn(EMERGENCY + digits.substring(digits.length() - CALLBACK_DIGITS));
    }
}
