/** The centre's window, "SMSyCT". It knows the centre only through {@link simgsm.center.ui.Operator}. */
package simgsm.center.ui;
