package simgsm.phone.handset;

import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.ss.ServiceCode;
import simgsm.ss.UssdText;

/** Performs a user's input before the green key, and USSD (TS 22.030, 6.5 and 6.7). */
final class ServiceCodes {
    private final Handset handset;

    ServiceCodes(Handset handset) {
        this.handset = handset;
    }

    /** Sends a service code, or calls a number. @throws IllegalArgumentException for any other text */
    Optional<Refusal> perform(String typed) {
        if (ServiceCode.isCode(typed)) {
            return send(typed);
        }
        return ServiceCode.isHidingCall(typed)
                ? Optional.of(Refusal.NUMBER_IS_SHOWN)
                : handset.dial(Msisdn.parse(ServiceCode.called(typed)));
    }

    /** Sends a USSD code, or the reply awaited by the network. */
    Optional<Refusal> send(String text) {
        if (!handset.isPowered()) {
            return Optional.of(Refusal.SWITCHED_OFF);
        }
        if (text.equals(ServiceCode.IMEI)) {
            showImei();
            return Optional.empty();
        }
        if (!UssdText.fits(text)) {
            return Optional.of(text.isEmpty() ? Refusal.EMPTY_TEXT : Refusal.USSD_TOO_LONG);
        }
        boolean isSent = handset.station().sendUssd(text);
        if (isSent) {
            handset.home().clear();
            handset.screens().ussdSent(text);
            handset.changed();
        }
        return isSent ? Optional.empty() : Optional.of(Refusal.USSD_UNDER_WAY);
    }

    /** Shows the IMEI, without the network (TS 22.030, 6.7.2). */
    void showImei() {
        String imei = handset.station().identity().imei().digits();
        handset.home().clear();
        handset.screens().showImei(imei);
        handset.report(new HandsetEvent.ImeiShown(imei));
    }
}
