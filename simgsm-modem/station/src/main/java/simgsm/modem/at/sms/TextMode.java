package simgsm.modem.at.sms;

import java.util.List;
import java.util.Locale;
import simgsm.air.Msisdn;
import simgsm.modem.at.AddressType;
import simgsm.modem.at.state.ClientSettings;
import simgsm.modem.at.state.ModemClock;
import simgsm.modem.at.state.SimMemory;
import simgsm.octets.OctetString;
import simgsm.octets.Timestamp;
import simgsm.sms.Alphabet;
import simgsm.sms.CellBroadcast;
import simgsm.sms.CellBroadcastPage;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.SmsAddress;
import simgsm.sms.StatusReportTpdu;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.Tpdu;
import simgsm.sms.UserData;
import simgsm.sms.ValidityPeriod;

/** Messages in text mode (TS 27.005, 3.1 and 3.4), for one client. */
public final class TextMode {
    private final ClientSettings settings;
    private final Msisdn serviceCenter;

    public TextMode(ClientSettings settings, Msisdn serviceCenter) {
        this.settings = settings;
        this.serviceCenter = serviceCenter;
    }

    /** A line of +CMGL, after its name. */
    public String listed(int index, SimMemory.Status status, OctetString octets, Tpdu tpdu) {
        String begin = index + "," + quoted(status.words()) + ",";
        if (tpdu instanceof DeliverTpdu deliver) {
            String more =
                    settings.showsHeader ? "," + type(deliver.originator()) + "," + length(deliver.userData()) : "";
            return begin + address(deliver.originator()) + ",," + stamp(deliver.timestamp()) + more + "\r\n"
                    + text(deliver.userData());
        }
        if (tpdu instanceof SubmitTpdu submit) {
            String more =
                    settings.showsHeader ? "," + type(submit.destination()) + "," + length(submit.userData()) : "";
            return begin + address(submit.destination()) + ",," + more + "\r\n" + text(submit.userData());
        }
        return begin + report(octets, (StatusReportTpdu) tpdu);
    }

    /** A message of +CMGR, after its name. */
    public String read(SimMemory.Status status, OctetString octets, Tpdu tpdu) {
        String begin = quoted(status.words()) + ",";
        if (tpdu instanceof DeliverTpdu deliver) {
            return begin + delivered(octets, deliver);
        }
        if (tpdu instanceof SubmitTpdu submit) {
            String validity = submit.validity().map(TextMode::validity).orElse("");
            String more = settings.showsHeader
                    ? "," + type(submit.destination()) + "," + octets.octet(0) + "," + submit.protocolIdentifier() + ","
                            + submit.userData().coding().octet() + "," + validity + center()
                            + length(submit.userData())
                    : "";
            return begin + address(submit.destination()) + "," + more + "\r\n" + text(submit.userData());
        }
        return begin + report(octets, (StatusReportTpdu) tpdu);
    }

    /** A message of +CMT, and of +CMGR after the status. */
    public String delivered(OctetString octets, DeliverTpdu deliver) {
        String more = settings.showsHeader
                ? "," + type(deliver.originator()) + "," + octets.octet(0) + "," + deliver.protocolIdentifier() + ","
                        + deliver.userData().coding().octet() + center() + length(deliver.userData())
                : "";
        return address(deliver.originator()) + ",," + stamp(deliver.timestamp()) + more + "\r\n"
                + text(deliver.userData());
    }

    /** A status report of +CDS. */
    public String report(OctetString octets, StatusReportTpdu report) {
        return octets.octet(0) + "," + report.reference() + "," + address(report.recipient()) + ","
                + type(report.recipient()) + "," + stamp(report.timestamp()) + "," + stamp(report.discharged()) + ","
                + report.status();
    }

    /** A page of +CBM. */
    public String page(CellBroadcastPage page) {
        return page.serial().value() + "," + page.messageIdentifier() + ","
                + page.coding().octet() + ","
                + page.page() + "," + page.pages() + "\r\n"
                + settings.characterSet.encode(CellBroadcast.join(List.of(page)).text());
    }

    private String center() {
        return "," + quoted(settings.characterSet.encode(serviceCenter.toString())) + ","
                + AddressType.of(serviceCenter.toString()) + ",";
    }

    private static String validity(ValidityPeriod validity) {
        if (validity instanceof ValidityPeriod.Relative relative) {
            return Integer.toString(relative.octet());
        }
        return validity instanceof ValidityPeriod.Absolute absolute ? stamp(absolute.time()) : "";
    }

    private String address(SmsAddress address) {
        return quoted(settings.characterSet.encode(address.toString()));
    }

    /** Type of address with its extension bit, such as 145. */
    private static int type(SmsAddress address) {
        return 0x80 | address.type() << 4 | address.plan();
    }

    /** TP-UDL: septets or octets. */
    private static int length(UserData data) {
        return data.length();
    }

    private static String stamp(Timestamp time) {
        return quoted(ModemClock.format(time.toOffsetDateTime()));
    }

    /** GSM text in the client's character set, all else as hexadecimal digits. */
    private String text(UserData data) {
        return data.coding().alphabet() == Alphabet.GSM_7BIT
                ? settings.characterSet.encode(data.text())
                : data.body().toString().toUpperCase(Locale.ROOT);
    }

    private static String quoted(String text) {
        return '"' + text + '"';
    }
}
