package simgsm.phone.handset;

import java.util.ArrayList;
import java.util.List;
import simgsm.air.Msisdn;
import simgsm.phone.screen.Words;
import simgsm.phone.store.Contacts;
import simgsm.sim.SimPhoneBook;
import simgsm.station.StationCommands;
import simgsm.station.StationSnapshot;

/** The lines of the page about the phone: number, IMEI, network, cell, use of the phone book. */
final class AboutPhone {
    private AboutPhone() {}

    static List<Words> lines(Msisdn own, StationCommands station, Contacts contacts) {
        StationSnapshot now = station.snapshot();
        List<Words> lines = new ArrayList<>();
        lines.add(Words.of("about.own", own.digits()));
        lines.add(Words.of("about.imei", station.identity().imei().digits()));
        lines.add(Words.of("about.network", now.networkName()));
        now.cell()
                .ifPresent(cell -> lines.add(Words.of(
                        "lcd.cell",
                        String.valueOf(cell.identity()),
                        String.valueOf(cell.areaCode()),
                        String.valueOf(cell.dbm()))));
        lines.add(Words.of("about.names", contacts.all().size(), SimPhoneBook.CAPACITY));
        return lines;
    }
}
