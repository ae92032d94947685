package simgsm.modem.at.state;

import java.util.HashMap;
import java.util.Map;
import simgsm.sms.ChannelList;

/** Settings of one client; each connection begins with these values, and ATZ and AT&F restore them. */
public final class ClientSettings {
    public CharacterSet characterSet = CharacterSet.IRA;

    // Calls.
    public boolean showsCaller;
    public boolean namesRingKind;
    public boolean showsWaiting;
    public boolean showsConnectedNumber;
    /** Asked for the sound of calls; it reads their progress as Huawei's codes. */
    public boolean takesSound;
    /** ATX: below 3 a busy line is reported as NO CARRIER. */
    public int callProgress = 4;
    /** S0: rings after which a call is answered, 0 for never. */
    public int ringsBeforeAnswer;
    /** VTD, in 0.1 s; 0 for the modem's own 100 ms. */
    public int keyTenths;

    // Keys heard.
    public boolean reportsKeys;
    public int equalKeysMillis;
    public boolean reportsKeyMillis;

    // Network.
    public int operatorFormat;
    public int ussdMode;

    // Messages.
    public boolean textMode;
    public boolean showsHeader;
    public boolean acknowledges;
    public int indicationMode;
    public int deliverMode;
    public int broadcastMode;
    public int reportMode;
    public int bufferMode;
    public ChannelList channels = ChannelList.ALL;
    public int submitFirstOctet = 17;
    public int submitValidity = 167;
    public int submitProtocol;
    public int submitCoding;

    public String phoneBook = "SM";

    /** Values of commands that only store them, by the command's name. */
    public final Map<String, String> kept = new HashMap<>();
}
