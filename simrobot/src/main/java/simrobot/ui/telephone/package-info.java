/** The window's view of the selected robot's telephone: modem, tone scope, VeriCommand and replies. */
package simrobot.ui.telephone;
