package simgsm.phone;

import java.util.List;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.modem.at.command.AtTerminal;
import simgsm.phone.handset.Handset;
import simgsm.sim.SimPhoneBook;
import simgsm.station.MobileStation;

/** The phone as a modem: AT commands act on the handset, which shows their effect. */
final class PhoneTerminal implements AtTerminal {
    private final Handset handset;
    private final MobileStation station;
    private final SimPhoneBook phoneBook;

    PhoneTerminal(Handset handset, MobileStation station, SimPhoneBook phoneBook) {
        this.phoneBook = phoneBook;
        this.handset = handset;
        this.station = station;
    }

    @Override
    public String model() {
        return "M1";
    }

    @Override
    public MobileStation station() {
        return station;
    }

    @Override
    public SimPhoneBook phoneBook() {
        return phoneBook;
    }

    @Override
    public boolean dial(Msisdn number) {
        return handset.dial(number).isEmpty();
    }

    @Override
    public boolean answer() {
        return handset.answer().isEmpty();
    }

    @Override
    public boolean hangUp() {
        return handset.hangUp().isEmpty();
    }

    @Override
    public boolean rejectWaiting() {
        return handset.rejectSecond().isEmpty();
    }

    @Override
    public boolean hold() {
        return handset.hold().isEmpty();
    }

    @Override
    public boolean hasCallWaiting() {
        return true;
    }

    @Override
    public void sendKeys(List<DtmfKey> keys, int toneMillis, Runnable sent) {
        handset.press(keys, toneMillis, sent);
    }

    @Override
    public void setPower(boolean on) {
        if (on) {
            handset.powerOn();
        } else {
            handset.powerOff();
        }
    }

    @Override
    public boolean sendUssd(String text) {
        return handset.codes().send(text).isEmpty();
    }

    @Override
    public void setMemoryAvailable(boolean available) {
        station.setMemoryAvailable(available);
    }
}
