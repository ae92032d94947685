package simgsm.phone.handset;

import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;

/** What screens and home keys have done, done by the handset. */
final class HandsetDeeds implements Screens.Deeds, HomeKeys.Deeds {
    private final Handset handset;

    HandsetDeeds(Handset handset) {
        this.handset = handset;
    }

    @Override
    public void dial(String number) {
        handset.dialText(number);
    }

    @Override
    public boolean send(Msisdn to, String text) {
        return handset.sendText(to, text);
    }

    @Override
    public void switchOff() {
        handset.powerOff();
    }

    @Override
    public void call(String number) {
        handset.dialText(number);
    }

    @Override
    public void answer() {
        handset.answer();
    }

    @Override
    public void sound(DtmfKey tone) {
        handset.keySounds(tone);
    }

    @Override
    public void silence() {
        handset.keyIsSilent();
    }
}
